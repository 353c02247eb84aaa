// The field as a page shows it: the scene on a canvas, what is said of the place under the pointer, and what can be dragged or drawn.
import {el, onThemeChange, style, Surface} from './dom.js';
import {host} from './host.js';
import {HeatChoice} from './heat.js';
import {figureSize, fit, legend, magnified, paintScene, paintTracks} from './scene.js';
import {named, obstacleAt} from './site.js';
import {densityAt, viewAt, viewName, viewOf, zoneAt} from './views.js';
import {decimals, metres} from './numbers.js';

const NEAR = 16;
const STILL = 3; // pixels a pressed camera may be off before it moves
const TIP_GAP = 16;
const ZOOM = 1.5;
const MOST_TIMES = 64;

export class FieldView {
  /**
   * @param run what is shown
   * @param on `select(camera)` when one is clicked, `pick(target)` when a target is; `drag(camera, x, y)`, if cameras can be moved; `line(ends)` when a wall has been
   *   drawn, its ends as x and y in turn, and `lining(ends)` while it is; `heat(figure)` when one of `figures` of the heat map is chosen, if there can be one
   */
  constructor(run, on) {
    this.run = run;
    this.on = on;
    this.frame = 0;
    this.selected = -1;
    this.opacity = 0.5;
    this.surface = new Surface(
      {class: 'field', role: 'img', tabindex: 0},
      (context, width, height) => this.paint(context, width, height),
    );
    this.tip = el('div', {class: 'tip', hidden: true});
    this.closer = {times: 1, left: 0, top: 0}; // how the map is magnified
    this.layer = document.createElement('canvas'); // with the tracks up to the frame `drawn`
    this.heat = on.heat && new HeatChoice(run.setup.field, on.figures, on.heat);
    this.floor = (run.setup.floor ?? []).map(({area, data}) => ({
      area,
      image: el('img', {src: data, onload: () => this.surface.draw()}),
    }));
    this.legend = el('div', {class: 'legend'});
    this.element = el(
      'div',
      {class: 'field-box much'},
      el('div', {class: 'field-frame'}, this.surface.canvas, this.tip, this.lens()),
      this.options(),
      this.legend,
    );
    this.readColours();
    onThemeChange(() => this.readColours());
    this.listen(this.surface.canvas);
  }

  /** What can be shown or not: a heat map, tracks, zones of pixel density, and the floorplan, more or less of it. */
  options() {
    const known = this.run.setup.cameras.some(({pose}) =>
      pose.lenses?.some(({density}) => density),
    );
    const box = (name, label) =>
      el(
        'label',
        {},
        el('input', {
          type: 'checkbox',
          name,
          onchange: event => this.set(name, event.target.checked),
        }),
        ` ${label}`,
      );
    this.beliefs = box(
      'believes',
      'what cameras believe: where targets are that were seen (circles), where others are expected (shaded), and which cameras received messages of the selected one (arrows)',
    );
    this.beliefs.hidden = true;
    const floor = () =>
      el('input', {
        type: 'range',
        name: 'floor',
        data: {keys: 'own'},
        min: 0,
        max: 100,
        step: 5,
        value: 100 * this.opacity,
        oninput: event => this.set('opacity', event.target.value / 100),
      });
    return el(
      'div',
      {class: 'field-options', role: 'group', 'aria-label': 'what the field shows'},
      ...(this.heat ? [el('label', {}, 'heat map ', this.heat.select), this.heat.key] : []),
      box('trails', 'last steps'),
      box('tracks', 'whole paths'),
      known ? box('zones', 'pixel density of the selected camera (IEC 62676-4:2025, px/m)') : null,
      this.floor.length ? el('label', {}, 'floorplan ', floor()) : null,
      this.beliefs,
    );
  }

  /** Buttons by which to look closer. */
  lens() {
    const button = (text, label, onclick) =>
      el('button', {type: 'button', 'aria-label': label, title: label, onclick}, text);
    const middle = times => this.magnify(times, this.surface.width / 2, this.surface.height / 2);
    this.whole = button('⤢', 'show the whole field', () => this.showWhole());
    this.whole.disabled = true;
    return el(
      'div',
      {class: 'lens', role: 'group', 'aria-label': 'look closer'},
      button('+', 'zoom in', () => middle(ZOOM)),
      button('−', 'zoom out', () => middle(1 / ZOOM)),
      this.whole,
    );
  }

  /** Makes the map larger about a place in pixels. */
  magnify(by, x, y) {
    const {times, left, top} = this.closer;
    const now = Math.min(MOST_TIMES, Math.max(1, times * by));
    this.look(now, x - ((x - left) * now) / times, y - ((y - top) * now) / times);
  }

  /** Moves the map, as far as some of it stays in sight. */
  look(times, left, top) {
    if (!this.fitted) return;
    const {width, height} = this.surface;
    const within = (offset, size) => Math.max(size * (1 - times), Math.min(0, offset));
    this.closer = {times, left: within(left, width), top: within(top, height)};
    this.whole.disabled = times === 1;
    this.lay();
    this.surface.draw();
  }

  showWhole() {
    this.look(1, 0, 0);
  }

  /** Shows an area in metres, with some of what is around it. */
  showArea({minX, maxX, minY, maxY}) {
    const {width, height} = this.surface;
    const map = this.fitted;
    const times = Math.min(
      MOST_TIMES,
      Math.max(
        1,
        0.4 *
          Math.min(
            width / Math.max(1, map.x(maxX) - map.x(minX)),
            height / Math.max(1, map.y(minY) - map.y(maxY)),
          ),
      ),
    );
    this.look(
      times,
      width / 2 - (times * (map.x(minX) + map.x(maxX))) / 2,
      height / 2 - (times * (map.y(minY) + map.y(maxY))) / 2,
    );
  }

  lay() {
    const {times, left, top} = this.closer;
    this.map = times === 1 ? this.fitted : magnified(this.fitted, times, left, top);
  }

  /** Keys of the field itself: +, - and 0, and arrows once it is magnified. */
  keyed(event) {
    const {times, left, top} = this.closer;
    const {width, height} = this.surface;
    const by = {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[
      event.key
    ];
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (by && times > 1) this.look(times, left + (by[0] * width) / 8, top + (by[1] * height) / 8);
    else if ('+=-'.includes(event.key))
      this.magnify(event.key === '-' ? 1 / ZOOM : ZOOM, width / 2, height / 2);
    else if (event.key === '0') this.showWhole();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Where everything is in sight, the page scrolls on. */
  wheeled(event) {
    if (event.deltaY > 0 && this.closer.times === 1) return;
    event.preventDefault();
    this.magnify(Math.exp(-event.deltaY / 400), event.offsetX, event.offsetY);
  }

  /** Changes what is shown: a frame, a chosen camera, an option. */
  set(name, value) {
    this[name] = value;
    this.surface.draw();
    if (name === 'zones' || (name === 'selected' && this.zones)) this.explain();
  }

  /** Shows a figure of the heat map; '' for none. */
  showHeat(figure) {
    this.heat.choose(figure);
    this.surface.draw();
  }

  /** Takes a heat map. */
  loadHeat(heat) {
    this.heat.load(heat);
    this.surface.draw();
  }

  /** Whether pressing in the field begins a wall. */
  drawLines(on) {
    this.draws = on;
    this.set('line', null);
  }

  show(frame) {
    this.beliefs.hidden = !this.run.belief.length;
    this.set('frame', frame);
    if (this.pointer) this.hover();
  }

  readColours() {
    const names = ['ink', 'faint', 'grid', 'paper', 'camera', 'range', 'wall', 'shadow', 'accent'];
    this.colours = Object.fromEntries(names.map(name => [name, style(`--${name}`)]));
    this.surface.draw();
    this.explain();
  }

  /** Writes the legend. */
  explain() {
    const entry = ({label, mark}) =>
      el(
        'span',
        {},
        mark &&
          new Surface({class: 'mark', 'aria-hidden': 'true'}, (context, width, height) =>
            mark(context, width / 2, height / 2, 0.4 * height),
          ).canvas,
        label,
      );
    this.legend.replaceChildren(...legend(this.scene()).flat().map(entry));
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
      zoned: this.zones ? selected : -1,
      heat: this.heat?.shown,
      belief: this.believes && run.belief[frame],
      floor: this.floor.filter(({image}) => image.complete),
      trails: this.trails,
      tracks: this.tracks && (context => this.paintTracks(context, scene)),
    };
    return scene;
  }

  listen(canvas) {
    canvas.addEventListener('pointermove', event => this.moved(event));
    canvas.addEventListener('pointerleave', () => {
      this.pointer = null;
      this.tip.hidden = true;
    });
    canvas.addEventListener('pointerdown', event => this.pressed(event));
    canvas.addEventListener('wheel', event => this.wheeled(event), {passive: false});
    canvas.addEventListener('keydown', event => this.keyed(event));
    for (const end of ['pointerup', 'pointercancel'])
      canvas.addEventListener(end, event => this.released(event.type === 'pointerup'));
  }

  pressed(event) {
    if (event.button !== 0) return;
    this.pointer = [event.offsetX, event.offsetY];
    if (this.draws) {
      const place = this.map.place(...this.pointer);
      this.line = [...place, ...place];
      this.surface.canvas.setPointerCapture(event.pointerId);
      return;
    }
    const {camera, target} = this.nearest();
    this.on.select(camera);
    if (camera < 0 && target >= 0) this.on.pick(target);
    if (camera >= 0 && this.on.drag) {
      const pose = this.run.pose(camera, this.frame);
      this.grabbed = {
        camera,
        at: this.pointer,
        centre: [this.map.x(pose.x), this.map.y(pose.y)],
        moves: false,
      };
      this.surface.canvas.setPointerCapture(event.pointerId);
    } else if (camera < 0 && this.closer.times > 1) {
      this.panned = {at: this.pointer, left: this.closer.left, top: this.closer.top};
      this.surface.canvas.setPointerCapture(event.pointerId);
    }
  }

  moved(event) {
    this.pointer = [event.offsetX, event.offsetY];
    if (this.grabbed) this.dragGrabbed(this.grabbed);
    if (this.panned)
      this.look(
        this.closer.times,
        this.panned.left + this.pointer[0] - this.panned.at[0],
        this.panned.top + this.pointer[1] - this.panned.at[1],
      );
    if (this.line) this.drawLine();
    this.hover();
  }

  drawLine() {
    this.line.splice(2, 2, ...this.map.place(...this.pointer));
    this.on.lining(this.line);
    this.surface.draw();
  }

  /** What was held is let go: a wall that has been drawn is there now, but for a mere click. */
  released(done) {
    this.grabbed = this.panned = null;
    const {line} = this;
    this.line = null;
    if (line && done && this.map.scale * Math.hypot(line[2] - line[0], line[3] - line[1]) >= STILL)
      this.on.line(line);
    this.surface.draw();
  }

  /** Moves the camera as far as the pointer has moved: it does not jump to where it was pressed. */
  dragGrabbed(grabbed) {
    const {camera, at, centre} = grabbed;
    const [right, down] = this.pointer.map((place, i) => place - at[i]);
    grabbed.moves ||= Math.hypot(right, down) >= STILL;
    if (grabbed.moves) this.on.drag(camera, ...this.map.place(centre[0] + right, centre[1] + down));
  }

  /** The camera and the target under the pointer; -1 for none. */
  nearest() {
    const {run, frame, map} = this;
    const [px, py] = this.pointer;
    const best = {camera: -1, target: -1};
    let least = NEAR * this.surface.unit;
    run.setup.targets.forEach((target, i) => {
      const gap = run.present[i][frame]
        ? Math.hypot(map.x(run.x[i][frame]) - px, map.y(run.y[i][frame]) - py)
        : Infinity;
      if (gap < least) [least, best.target] = [gap, i];
    });
    least = NEAR * this.surface.unit;
    run.setup.cameras.forEach((camera, i) => {
      const pose = run.pose(i, frame);
      const gap = Math.hypot(map.x(pose.x) - px, map.y(pose.y) - py);
      if (gap < least) [least, best.camera] = [gap, i];
    });
    return best;
  }

  hover() {
    if (!this.map || !this.run.count) return;
    const {camera, target} = this.nearest();
    const lines =
      target >= 0
        ? this.describeTarget(target)
        : camera >= 0
          ? this.describeCamera(camera)
          : this.describePlace();
    this.tip.hidden = !lines;
    if (!lines) return;
    this.tip.textContent = lines.join('\n');
    const left = besides(this.pointer[0], this.tip.offsetWidth, this.surface.width);
    const top = besides(this.pointer[1], this.tip.offsetHeight, this.surface.height);
    this.tip.style.transform = `translate(${left}px, ${top}px)`;
  }

  describeTarget(i) {
    const {run, frame} = this;
    const k = run.coverage[i][frame];
    return [
      `target ${run.setup.targets[i].name}`,
      `x ${metres(run.x[i][frame])}, y ${metres(run.y[i][frame])}`,
      `covered by ${k} camera${k === 1 ? '' : 's'}`,
      `size ${decimals(run.setup.targets[i].size, 3)} m${run.setup.widths ? `, ${decimals(run.setup.widths[i], 3)} m wide` : ''}`,
    ];
  }

  describeCamera(i) {
    const {run, frame} = this;
    const pose = run.pose(i, frame);
    const view = run.level[i][frame];
    return [
      `camera ${run.setup.cameras[i].name}`,
      `x ${metres(pose.x)}, y ${metres(pose.y)}`,
      run.online[i][frame]
        ? describeView(pose, view) +
          (run.seen(i, frame) < 0 ? ', on its way to it: sees nothing' : '')
        : 'not online',
      `detects ${run.detected[i][frame]} of ${run.targets[frame]} targets`,
    ];
  }

  /** The obstacle under the pointer, and what zones and heat map say of the place where they are shown. */
  describePlace() {
    const {surface, run} = this;
    const obstacle = obstacleAt(
      surface.canvas.getContext('2d'),
      run.setup.obstacles ?? [],
      this.map,
      surface.unit,
      ...this.pointer,
    );
    const lines = obstacle ? [named(obstacle)] : [];
    const online = this.zones && run.online[this.selected]?.[this.frame];
    const density = online
      ? densityAt(this.view(this.selected), ...this.map.place(...this.pointer))
      : NaN;
    if (Number.isFinite(density)) lines.push(`${decimals(density, 1)} px/m: ${zoneAt(density)}`);
    if (this.heat) lines.push(...this.heat.describe(...this.map.place(...this.pointer)));
    return lines.length ? lines : null;
  }

  /** What a camera sees in this frame. */
  view(camera) {
    return viewAt(this.run, camera, this.frame);
  }

  paint(context, width, height) {
    const {run} = this;
    if (this.surface.changed) {
      this.surface.changed = false;
      this.fitted = fit(run.setup.field, width, height, this.surface.unit);
      this.lay();
    }
    context.fillStyle = this.colours.paper;
    context.fillRect(0, 0, width, height);
    if (!run.count) return;
    const scene = this.scene();
    this.size = figureSize(scene);
    paintScene(context, scene);
    if (this.line) this.paintLine(context, scene);
    this.label();
  }

  /** The tracks in a layer of their own: only what is new is drawn, however long they are. */
  paintTracks(context, scene) {
    const {canvas} = context;
    const {layer, run} = this;
    const lines = layer.getContext('2d');
    if (
      scene.map !== this.traced?.map ||
      scene.colours !== this.traced.colours ||
      run.count < this.drawn
    ) {
      [layer.width, layer.height] = [canvas.width, canvas.height];
      lines.setTransform(context.getTransform());
      this.drawn = 0;
    }
    paintTracks(lines, scene, this.drawn);
    this.traced = scene;
    this.drawn = run.count;
    context.resetTransform();
    context.drawImage(layer, 0, 0);
  }

  /** The wall that is being drawn. */
  paintLine(context, {map, unit, colours}) {
    const [x1, y1, x2, y2] = this.line;
    context.strokeStyle = colours.accent;
    context.lineWidth = 3 * unit;
    context.beginPath();
    context.moveTo(map.x(x1), map.y(y1));
    context.lineTo(map.x(x2), map.y(y2));
    context.stroke();
  }

  /** What the picture says, for those who do not see it. */
  label() {
    const row = this.run.row(this.frame);
    this.surface.canvas.setAttribute(
      'aria-label',
      `The field at step ${row.step}: ${row.targets} targets, ` +
        `${row.covered_0} covered by no camera, ${row.covered_1} by one, ${row.covered_k} by two or more.` +
        (this.heat?.shown ? ` Heat map: ${this.heat.summary()}.` : ''),
    );
  }
}

/** Where something of this size begins: after the pointer, or before it where there is no room. */
function besides(pointer, size, room) {
  const after = pointer + TIP_GAP;
  return Math.max(0, after + size <= room ? after : pointer - TIP_GAP - size);
}

/** A view in words. */
function describeView(pose, view) {
  const {level, viewingAngle} = viewOf(pose, view);
  return (
    `${viewName(pose, view)}, ` +
    (pose.lenses
      ? `${decimals((viewingAngle * 180) / Math.PI, 1)}° wide`
      : `radius ${decimals(level.radius, 3)} m`)
  );
}
