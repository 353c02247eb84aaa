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
   * @param run what is shown
   * @param on `select(camera)` when a camera is clicked, `pick(target)` when a target is;
   *   `drag(camera, x, y)`, if cameras can be moved; `line(places)` when an outline has been drawn,
   *   x and y of both places in turn, and `drawing(places)` while it is; `heat(figure)` when one of
   *   `figures` of the heat map is chosen, if there can be a heat map
   */
  constructor(run, on) {
    this.run = run;
    this.frame = 0;
    this.selected = -1;
    this.opacity = 0.5;
    this.drawing = ''; // the outline that pressing begins; '' for none
    this.surface = new Surface(
      {class: 'field', role: 'img', tabindex: 0},
      (context, width, height) => this.paint(context, width, height),
    );
    this.magnifier = new Magnifier(this.surface, () => this.surface.draw());
    this.tooltip = new Tooltip(this.surface);
    this.pointer = new FieldPointer(this, on);
    this.trackCanvas = new TrackCanvas();
    this.heat = on.heat && new HeatChoice(run.setup.field, on.figures, on.heat);
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

  /** Changes what is shown: a frame, the selected camera, an option. */
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
    if (this.pointer.place) this.describe();
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

  /** Sets the outline that pressing in the field begins; '' for none. */
  setDrawing(outline) {
    this.drawing = outline;
    this.pointer.forgetLine();
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

  /** Writes into the tooltip what is under the pointer. */
  describe() {
    const {map, run, frame, pointer} = this;
    if (!map || !run.count) return;
    const {camera, target} = pointer.nearest();
    const lines =
      target >= 0
        ? describeTarget(run, frame, target)
        : camera >= 0
          ? describeCamera(run, frame, camera)
          : describePlace(this, pointer.place);
    this.tooltip.show(lines, pointer.place);
  }

  /** All that the field shows: see paintScene. */
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
      this.magnifier.fitted(fit(run.setup.field, width, height, surface.unit));
    }
    context.fillStyle = this.colours.paper;
    context.fillRect(0, 0, width, height);
    if (!run.count) return;
    const scene = this.scene();
    this.size = figureSize(scene);
    paintScene(context, scene);
    if (this.pointer.line) paintOutline(context, scene, this.drawing, this.pointer.line);
    this.updateLabel();
  }

  /** Writes what the picture shows, for those who do not see it. */
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
