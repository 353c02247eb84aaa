// The field of a run as a page shows it: the scene on a canvas, with its options and legend.
import {el, onThemeChange, style, Surface} from './dom.js';
import {fieldOptions} from './field-options.js';
import {FieldPointer} from './field-pointer.js';
import {paintOutline} from './drawn-outline.js';
import {figureSize} from './figure-size.js';
import {HeatChoice} from './heat.js';
import {host} from './host.js';
import {legend} from './legend.js';
import {Magnifier} from './magnifier.js';
import {fit} from './map.js';
import {paintScene} from './scene.js';
import {describeCamera, describePlace, describeTarget, Tooltip} from './tooltip.js';
import {TrackCanvas} from './track-canvas.js';
import {viewAt} from './views.js';
import {hasOutlines} from './zone-layer.js';

const COLOURS = ['ink', 'faint', 'grid', 'paper', 'camera', 'range', 'wall', 'shadow', 'accent'];

export class FieldView {
  /**
   * @param run the run that is shown
   * @param handlers functions that are called: `select(camera)` and `pick(target)` after a click;
   *   `drag(camera, x, y)` in metres, if cameras can be moved; `drawing(ends)` while an outline is
   *   drawn and `line(ends)` at its end, with x1, y1, x2 and y2 in metres; `heat(figure)` when one
   *   of the heat map's `figures` is chosen, if there can be a heat map
   */
  constructor(run, handlers) {
    this.run = run;
    this.frame = 0;
    this.selected = -1;
    this.opacity = 0.5;
    this.drawing = ''; // the outline that a press begins; '' for none
    this.surface = new Surface(
      {class: 'field', role: 'img', tabindex: 0},
      (context, width, height) => this.paint(context, width, height),
    );
    this.magnifier = new Magnifier(this.surface, () => this.surface.draw());
    this.tooltip = new Tooltip(this.surface);
    this.pointer = new FieldPointer(this, handlers);
    this.trackCanvas = new TrackCanvas();
    this.heat = handlers.heat && new HeatChoice(run.setup.field, handlers.figures, handlers.heat);
    this.floor = (run.setup.floor ?? []).map(({area, data}) => ({
      area,
      image: el('img', {src: data, onload: () => this.surface.draw()}),
    }));
    this.options = fieldOptions(this);
    this.legend = el('div', {class: 'legend'});
    this.element = el(
      'div',
      {class: 'field-box much'},
      el(
        'div',
        {class: 'field-frame'},
        this.surface.canvas,
        this.tooltip.element,
        this.magnifier.element,
      ),
      this.options.element,
      this.legend,
    );
    this.readColours();
    onThemeChange(() => this.readColours());
  }

  /** The map from metres to pixels. */
  get map() {
    return this.magnifier.map;
  }

  /** The view of a camera in the frame that is shown. */
  view(camera) {
    return viewAt(this.run, camera, this.frame);
  }

  /** Sets a property that the field shows, such as the frame, the selected camera or an option. */
  set(name, value) {
    const hadZones = hasOutlines(this.zones);
    this[name] = value;
    this.surface.draw();
    const inLegend = name === 'densityZones' || (name === 'selected' && this.densityZones);
    if (inLegend || hadZones !== hasOutlines(this.zones)) this.writeLegend();
  }

  show(frame) {
    this.options.beliefs.hidden = !this.run.belief.length;
    this.set('frame', frame);
    if (this.pointer.position) this.describe();
  }

  /** Shows a figure of the heat map; '' for none. */
  showHeat(figure) {
    this.heat.choose(figure);
    this.surface.draw();
  }

  loadHeat(heat) {
    this.heat.load(heat);
    this.surface.draw();
  }

  /** Sets the outline that a press in the field begins; '' for none. */
  setDrawing(outline) {
    this.drawing = outline;
    this.pointer.forgetOutline();
    this.surface.draw();
  }

  readColours() {
    this.colours = Object.fromEntries(COLOURS.map(name => [name, style(`--${name}`)]));
    this.surface.draw();
    this.writeLegend();
  }

  writeLegend() {
    const entry = ({label, mark}) => el('span', {}, mark && legendSign(mark), label);
    this.legend.replaceChildren(...legend(this.scene()).flat().map(entry));
  }

  /** Shows a tooltip for the camera, the target or else the position under the pointer. */
  describe() {
    const {map, run, frame, pointer} = this;
    if (!map || !run.count) return;
    const {camera, target} = pointer.nearest();
    const lines =
      target >= 0
        ? describeTarget(run, frame, target)
        : camera >= 0
          ? describeCamera(run, frame, camera)
          : describePlace(this, pointer.position);
    this.tooltip.show(lines, pointer.position);
  }

  /** Returns everything that the field shows: see paintScene. */
  scene() {
    const {run, frame, map, colours, selected, opacity} = this;
    const scene = {
      run,
      frame,
      map,
      colours,
      selected,
      opacity,
      host,
      unit: this.surface.unit ?? 1,
      densityCamera: this.densityZones ? selected : -1,
      heat: this.heat?.shown,
      belief: this.beliefs && run.belief[frame],
      floor: this.floor.filter(({image}) => image.complete),
      zones: this.zones,
      trails: this.trails,
      tracks: this.tracks && (context => this.trackCanvas.paint(context, scene)),
    };
    return scene;
  }

  paint(context, width, height) {
    const {run, surface} = this;
    if (surface.changed) {
      surface.changed = false;
      this.magnifier.setWholeMap(fit(run.setup.field, width, height, surface.unit));
    }
    context.fillStyle = this.colours.paper;
    context.fillRect(0, 0, width, height);
    if (!run.count) return;
    const scene = this.scene();
    this.size = figureSize(scene);
    paintScene(context, scene);
    if (this.pointer.ends) paintOutline(context, scene, this.drawing, this.pointer.ends);
    this.updateLabel();
  }

  /** Describes the picture in words, which screen readers read. */
  updateLabel() {
    const row = this.run.row(this.frame);
    const heat = this.heat?.shown ? ` Heat map: ${this.heat.summary()}.` : '';
    this.surface.canvas.setAttribute(
      'aria-label',
      `The field at step ${row.step}: ${row.targets} targets, ` +
        `${row.covered_0} covered by no camera, ${row.covered_1} by one, ` +
        `${row.covered_k} by two or more.${heat}`,
    );
  }
}

const legendSign = mark =>
  new Surface({class: 'mark', 'aria-hidden': 'true'}, (context, width, height) =>
    mark(context, width / 2, height / 2, 0.4 * height),
  ).canvas;
