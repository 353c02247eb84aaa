// The field to scale: cameras with their fields of view, the ranges in which they detect, targets and trails.
import { el, metres, decimals, onThemeChange, style, Surface } from './dom.js';
import { COVER, coverClass, shape } from './palette.js';
import { densityAt, paintZones, ZONES, zoneAt } from './density.js';
import { HeatLayer } from './heat.js';
import { named, Site } from './site.js';
import { Tracks } from './tracks.js';
import { fillDetected, inSight, sector, signed, viewOf } from './views.js';

const TRAIL = 40;
const NEAR = 16;
const STILL = 3; // pixels a pressed camera may be off before it moves
const TIP_GAP = 16;
const TRAIL_SEGMENTS = 1500;
const MARGIN = [46, 36]; // for the numbers along the borders
const ROOM = 40; // pixels a figure has about it before it shrinks

export class FieldView {
  /**
   * @param run what is shown
   * @param on `select(camera)` when one is clicked; `drag(camera, x, y)`, if cameras can be moved; `line(ends)` when a wall has been
   *   drawn, its ends as x and y in turn, and `lining(ends)` while it is; `heat(figure)` when a figure of the heat map is chosen, if there can be one
   */
  constructor(run, on) {
    this.run = run;
    this.on = on;
    this.frame = 0;
    this.selected = -1;
    this.prominence = prominence(run.setup);
    this.surface = new Surface({class: 'field', role: 'img', tabindex: 0}, (context, width, height) => this.paint(context, width, height));
    this.tip = el('div', {class: 'tip', hidden: true});
    this.tracks = new Tracks(run);
    this.heat = on.heat && new HeatLayer(run.setup, on.heat);
    this.site = new Site(run.setup, () => this.surface.draw());
    const [options, more] = [this.options(), this.site.legend(run.setup)];
    this.element = el('div', {class: 'field-box much'}, this.surface.canvas, this.tip, options, legend(more));
    this.readColours();
    onThemeChange(() => {
      this.readColours();
      this.surface.draw();
    });
    this.listen(this.surface.canvas);
  }

  /** What can be shown or not: a heat map, tracks, zones of pixel density, and the floorplan, more or less of it. */
  options() {
    const known = this.run.setup.cameras.some(({pose}) => pose.lenses?.some(({density}) => density));
    const zones = el('input', {type: 'checkbox', name: 'zones', onchange: () => this.showZones(zones.checked)});
    this.zoneKey = el('span', {class: 'zone-key', hidden: true}, ...ZONES.map(({name, least, colour}) => swatch(colour, `${name} ${least}`)));
    const floor = el('input', {type: 'range', name: 'floor', data: {keys: 'own'}, min: 0, max: 100, step: 5, value: 100 * this.site.opacity, oninput: () => this.fade(floor.value / 100)});
    const tracks = el('input', {type: 'checkbox', name: 'tracks', onchange: () => this.showTracks(tracks.checked)});
    const parts = [
      ...(this.heat ? [el('label', {}, 'heat map ', this.heat.select), this.heat.key] : []),
      el('label', {}, tracks, ' tracks'),
      ...(known ? [el('label', {}, zones, ' pixel density of the chosen camera (EN 62676-4, px/m)'), this.zoneKey] : []),
      ...(this.site.floor.length ? [el('label', {}, 'floorplan ', floor)] : []),
    ];
    return el('div', {class: 'field-options', role: 'group', 'aria-label': 'what the field shows'}, ...parts);
  }

  showTracks(on) {
    this.tracked = on;
    this.surface.draw();
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

  showZones(on) {
    this.zones = on;
    this.zoneKey.hidden = !on;
    this.surface.draw();
  }

  fade(opacity) {
    this.site.opacity = opacity;
    this.surface.draw();
  }

  /** Whether pressing in the field begins a wall. */
  drawLines(on) {
    this.draws = on;
    this.line = null;
    this.surface.draw();
  }

  show(frame) {
    this.frame = frame;
    this.surface.draw();
    if (this.pointer) this.hover();
  }

  select(camera) {
    this.selected = camera;
    this.surface.draw();
  }

  readColours() {
    this.colours = Object.fromEntries(['ink', 'faint', 'grid', 'paper', 'camera', 'range', 'wall', 'shadow', 'accent'].map(name => [name, style(`--${name}`)]));
  }

  listen(canvas) {
    canvas.addEventListener('pointermove', event => this.moved(event));
    canvas.addEventListener('pointerleave', () => {
      this.pointer = null;
      this.tip.hidden = true;
    });
    canvas.addEventListener('pointerdown', event => this.pressed(event));
    for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, event => this.released(event.type === 'pointerup'));
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
    const camera = this.nearest().camera;
    this.on.select(camera);
    if (camera >= 0 && this.on.drag) {
      const pose = this.run.pose(camera, this.frame);
      this.grabbed = {camera, at: this.pointer, centre: [this.map.x(pose.x), this.map.y(pose.y)], moves: false};
      this.surface.canvas.setPointerCapture(event.pointerId);
    }
  }

  moved(event) {
    this.pointer = [event.offsetX, event.offsetY];
    if (this.grabbed) this.dragGrabbed(this.grabbed);
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
    this.grabbed = null;
    const {line} = this;
    this.line = null;
    if (line && done && this.map.scale * Math.hypot(line[2] - line[0], line[3] - line[1]) >= STILL) this.on.line(line);
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
      const gap = run.present[i][frame] ? Math.hypot(map.x(run.x[i][frame]) - px, map.y(run.y[i][frame]) - py) : Infinity;
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
    const lines = target >= 0 ? this.describeTarget(target) : camera >= 0 ? this.describeCamera(camera) : this.describePlace();
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
    return [`target ${run.setup.targets[i].name}`, `x ${metres(run.x[i][frame])}, y ${metres(run.y[i][frame])}`,
      `covered by ${k} camera${k === 1 ? '' : 's'}`, `size ${decimals(run.setup.targets[i].size, 3)} m${run.setup.widths ? `, ${decimals(run.setup.widths[i], 3)} m wide` : ''}`];
  }

  describeCamera(i) {
    const {run, frame} = this;
    const pose = run.pose(i, frame);
    const view = run.level[i][frame];
    return [`camera ${run.setup.cameras[i].name}`, `x ${metres(pose.x)}, y ${metres(pose.y)}`,
      run.online[i][frame] ? describeView(pose, view) + (run.seen(i, frame) < 0 ? ', on its way to it: sees nothing' : '') : 'not online',
      `detects ${run.detected[i][frame]} of ${run.targets[frame]} targets`];
  }

  /** The obstacle under the pointer, and what zones and heat map say of the place where they are shown. */
  describePlace() {
    const obstacle = this.site.at(this.surface.canvas.getContext('2d'), ...this.pointer);
    const lines = obstacle >= 0 ? [named(this.site.obstacles[obstacle])] : [];
    const online = this.zones && this.run.online[this.selected]?.[this.frame];
    const density = online ? densityAt(this.view(this.selected), ...this.map.place(...this.pointer)) : NaN;
    if (Number.isFinite(density)) lines.push(`${decimals(density, 1)} px/m: ${zoneAt(density)}`);
    if (this.heat) lines.push(...this.heat.told(...this.map.place(...this.pointer)));
    return lines.length ? lines : null;
  }

  paint(context, width, height) {
    const {run, frame} = this;
    if (this.surface.changed) {
      this.map = fit(run.setup.field, width, height, this.surface.unit);
      this.site.fit(this.map, this.surface.unit);
      this.surface.changed = false;
    }
    this.size = this.figureSize(width, height);
    context.fillStyle = this.colours.paper;
    context.fillRect(0, 0, width, height);
    this.site.paintFloor(context);
    this.paintGrid(context, width, height);
    if (!run.count) return;
    this.heat?.paint(context, this.map, this.surface.unit);
    this.paintSight(context);
    if (this.tracked) this.tracks.paint(context, this.map, this.colours.ink, this.surface.unit);
    this.paintTrails(context);
    run.setup.cameras.forEach((camera, i) => this.paintCamera(context, i));
    run.setup.targets.forEach((target, i) => run.present[i][frame] && this.paintTarget(context, i));
    this.paintLine(context);
    this.label();
  }

  /** How large cameras and targets are drawn: smaller where there are many. */
  figureSize(width, height) {
    const room = Math.sqrt((width * height) / (this.run.setup.cameras.length + this.run.most + 1));
    return this.surface.unit * Math.max(0.3, Math.min(1, room / (ROOM * this.surface.unit)));
  }

  paintGrid(context, width, height) {
    const {map, colours} = this;
    const {minX, maxX, minY, maxY} = this.run.setup.field;
    const {unit} = this.surface;
    const gap = niceGap((90 * unit) / map.scale);
    context.lineWidth = 1;
    context.strokeStyle = colours.grid;
    context.fillStyle = colours.faint;
    context.font = `${11 * unit}px sans-serif`;
    context.beginPath();
    context.textAlign = 'center';
    for (let x = Math.ceil(minX / gap) * gap; x <= maxX + 1e-9; x += gap) {
      context.moveTo(map.x(x), map.y(minY));
      context.lineTo(map.x(x), map.y(maxY));
      context.fillText(decimals(x, 3), map.x(x), map.y(minY) + 14 * unit);
    }
    context.textAlign = 'right';
    for (let y = Math.ceil(minY / gap) * gap; y <= maxY + 1e-9; y += gap) {
      context.moveTo(map.x(minX), map.y(y));
      context.lineTo(map.x(maxX), map.y(y));
      context.fillText(decimals(y, 3), map.x(minX) - 5 * unit, map.y(y) + 4 * unit);
    }
    context.stroke();
    context.strokeStyle = colours.faint;
    context.strokeRect(map.x(minX), map.y(maxY), map.x(maxX) - map.x(minX), map.y(minY) - map.y(maxY));
    context.textAlign = 'right';
    context.fillText('metres', map.x(maxX), map.y(minY) + 28 * unit);
  }

  /** The field of view as an outline, the ranges in which a target of the usual size is detected as areas. */
  paintView(context, i) {
    const {run, frame, map, colours} = this;
    const blind = run.seen(i, frame) < 0;
    const view = this.view(i);
    const chosen = i === this.selected;
    const {unit} = this.surface;
    inSight(context, map, view, () => {
      context.fillStyle = colours.range;
      context.globalAlpha = chosen ? 0.4 : 0.13;
      if (!blind && !(chosen && this.zones) && !this.heat?.shown) fillDetected(context, map, view);
      context.globalAlpha = chosen ? 1 : 0.55;
      context.strokeStyle = colours.range;
      context.lineWidth = (chosen ? 2.5 : 1) * unit;
      context.setLineDash(blind ? [2 * unit, 5 * unit] : chosen ? [] : [5 * unit, 4 * unit]);
      context.beginPath();
      sector(context, map, view, view.reach);
      context.stroke();
      context.setLineDash([]);
      context.globalAlpha = 1;
    });
  }

  /** What a camera sees in this frame, or will see once it has moved. */
  view(i) {
    const {run, frame} = this;
    const seen = run.seen(i, frame);
    return viewOf(run.pose(i, frame), seen < 0 ? run.level[i][frame] : seen);
  }

  paintSight(context) {
    const {run, frame, map} = this;
    const online = run.setup.cameras.map((camera, i) => i).filter(i => run.online[i][frame]);
    const {selected} = this;
    if (this.zones && online.includes(selected) && run.seen(selected, frame) >= 0) {
      paintZones(context, map, this.view(selected), this.colours, this.surface.unit);
    }
    online.forEach(i => this.paintView(context, i));
    if (this.site.obstacles.length) {
      if (!this.heat?.shown) this.site.paintShadows(context, online.filter(i => run.seen(i, frame) >= 0).map(i => this.view(i)), this.colours.shadow);
      this.site.paintObstacles(context, this.colours.wall);
    }
  }

  paintLine(context) {
    if (!this.line) return;
    const [x1, y1, x2, y2] = this.line;
    context.strokeStyle = this.colours.accent;
    context.lineWidth = 3 * this.surface.unit;
    context.beginPath();
    context.moveTo(this.map.x(x1), this.map.y(y1));
    context.lineTo(this.map.x(x2), this.map.y(y2));
    context.stroke();
  }

  paintTrails(context) {
    const {run, frame, map} = this;
    const length = Math.ceil(Math.min(TRAIL, TRAIL_SEGMENTS / run.most));
    const first = Math.max(1, frame - length + 1);
    context.lineCap = 'round';
    for (let i = 0; i < run.setup.targets.length; i++) {
      for (let f = first; f <= frame; f++) {
        if (!run.present[i][f] || !run.present[i][f - 1]) continue;
        const cover = COVER[coverClass(run.coverage[i][f])];
        context.globalAlpha = 0.15 + (0.75 * (f - first + 1)) / (frame - first + 1);
        context.strokeStyle = cover.colour;
        context.lineWidth = cover.width * this.size;
        context.beginPath();
        context.moveTo(map.x(run.x[i][f - 1]), map.y(run.y[i][f - 1]));
        context.lineTo(map.x(run.x[i][f]), map.y(run.y[i][f]));
        context.stroke();
      }
    }
    context.globalAlpha = 1;
  }

  /** A square with a short line along its view; hollow and crossed out while it is not online. */
  paintCamera(context, i) {
    const {run, frame, map, colours} = this;
    const pose = this.view(i);
    const [x, y] = [map.x(pose.x), map.y(pose.y)];
    const r = (i === this.selected ? 7 : 5) * this.size;
    const online = run.online[i][frame];
    context.lineWidth = 1.5 * this.size;
    context.fillStyle = online ? colours.camera : colours.paper;
    context.strokeStyle = online ? colours.paper : colours.camera;
    context.beginPath();
    context.rect(x - r, y - r, 2 * r, 2 * r);
    context.fill();
    context.stroke();
    context.strokeStyle = colours.camera;
    context.beginPath();
    if (pose.viewingAngle < 2 * Math.PI) {
      context.moveTo(x, y);
      context.lineTo(x + 2.4 * r * Math.sin(pose.heading), y - 2.4 * r * Math.cos(pose.heading));
    }
    if (!online) {
      context.moveTo(x - r, y - r);
      context.lineTo(x + r, y + r);
    }
    context.stroke();
  }

  paintTarget(context, i) {
    const {run, frame, map, colours} = this;
    const k = run.coverage[i][frame];
    const kind = coverClass(k);
    const [x, y] = [map.x(run.x[i][frame]), map.y(run.y[i][frame])];
    const width = run.setup.widths?.[i] ?? run.setup.targets[i].size;
    const r = Math.max(9 * this.size * this.prominence[i], (map.scale * width) / 2);
    context.fillStyle = COVER[kind].colour;
    context.strokeStyle = colours.ink;
    context.lineWidth = 1.5 * this.size;
    context.beginPath();
    shape(context, kind, x, y, r);
    context.fill();
    context.stroke();
    if (kind > 0) {
      context.fillStyle = '#000';
      context.font = `bold ${Math.round(r * 1.15)}px sans-serif`;
      context.textAlign = 'center';
      context.fillText(k, x, y + r * (kind === 1 ? 0.55 : 0.42));
    }
  }

  /** What the picture says, for those who do not see it. */
  label() {
    const row = this.run.row(this.frame);
    this.surface.canvas.setAttribute('aria-label', `The field at step ${row.step}: ${row.targets} targets, ` +
      `${row.covered_0} covered by no camera, ${row.covered_1} by one, ${row.covered_k} by two or more.` +
      (this.heat?.shown ? ` Heat map: ${this.heat.summary()}.` : ''));
  }
}

/** Where something of this size begins: after the pointer, or before it where there is no room. */
function besides(pointer, size, room) {
  const after = pointer + TIP_GAP;
  return Math.max(0, after + size <= room ? after : pointer - TIP_GAP - size);
}

/** Maps metres to pixels, the whole field in sight, y upwards. */
function fit({minX, maxX, minY, maxY}, width, height, unit) {
  const [across, down] = MARGIN.map(margin => 2 * margin * unit);
  const scale = Math.max(1e-9, Math.min((width - across) / (maxX - minX), (height - down) / (maxY - minY)));
  const left = width / 2 - (scale * (minX + maxX)) / 2;
  const top = height / 2 + (scale * (minY + maxY)) / 2;
  return {
    scale,
    x: x => left + scale * x,
    y: y => top - scale * y,
    place: (px, py) => [(px - left) / scale, (top - py) / scale],
  };
}

/** 1, 2 or 5 times a power of ten, at least this much. */
function niceGap(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * [1, 2, 5, 10].find(factor => factor * power >= least);
}

/** A view in words. */
function describeView(pose, view) {
  const {zoom, pan, level, viewingAngle} = viewOf(pose, view);
  return `level ${zoom}, ${pose.pans ? `${signed(pan)}, ` : ''}` +
    (pose.lenses ? `${decimals((viewingAngle * 180) / Math.PI, 1)}° wide` : `radius ${decimals(level.radius, 3)} m`);
}

/** How large targets are drawn whose own size would be too small: by their widths, where these differ. */
function prominence({targets, widths, targetSize}) {
  const all = widths ?? targets.map(({size}) => size);
  const alike = new Set(all).size < 2;
  return all.map(width => (alike ? 1 : Math.max(0.6, Math.min(2, width / targetSize))));
}

function swatch(colour, text) {
  const mark = el('i', {class: 'swatch'});
  mark.style.background = colour;
  return el('span', {}, mark, text);
}

function legend(more) {
  const items = COVER.map((cover, kind) => {
    const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    svg.setAttribute('viewBox', '-10 -10 20 20');
    svg.setAttribute('aria-hidden', 'true');
    const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
    path.setAttribute('d', outline(kind));
    path.setAttribute('fill', cover.colour);
    svg.append(path);
    return el('span', {}, svg, cover.label);
  });
  return el('div', {class: 'legend'}, 'covered by', ...items, el('span', {class: 'key-view'}, 'field of view'),
    el('span', {class: 'key-range'}, 'detection range'), ...more.map(([mark, text]) => el('span', {class: mark}, text)));
}

/** A shape as the data of an SVG path. */
function outline(kind) {
  const words = [];
  shape({
    moveTo: (x, y) => words.push(`M${x} ${y}`),
    lineTo: (x, y) => words.push(`L${x} ${y}`),
    closePath: () => words.push('Z'),
    rect: (x, y, w, h) => words.push(`M${x} ${y}h${w}v${h}h${-w}Z`),
    arc: (x, y, r) => words.push(`A${r} ${r} 0 1 1 ${x - r} ${y}A${r} ${r} 0 1 1 ${x + r} ${y}`),
  }, kind, 0, 0, 8);
  return words.join('');
}
