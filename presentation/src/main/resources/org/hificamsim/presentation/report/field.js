// The field to scale: cameras with their fields of view, the ranges in which they detect, targets and trails.
import { el, metres, decimals, onThemeChange, style, Surface } from './dom.js';
import { COVER, coverClass, shape } from './palette.js';

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
   * @param on `select(camera)` when one is clicked; `drag(camera, x, y)`, if cameras can be moved
   */
  constructor(run, on) {
    this.run = run;
    this.on = on;
    this.frame = 0;
    this.selected = -1;
    this.surface = new Surface({class: 'field', role: 'img', tabindex: 0}, (context, width, height) => this.paint(context, width, height));
    this.tip = el('div', {class: 'tip', hidden: true});
    this.element = el('div', {class: 'field-box'}, this.surface.canvas, this.tip, legend());
    this.readColours();
    onThemeChange(() => {
      this.readColours();
      this.surface.draw();
    });
    this.listen(this.surface.canvas);
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
    this.colours = Object.fromEntries(['ink', 'faint', 'grid', 'paper', 'camera', 'range'].map(name => [name, style(`--${name}`)]));
  }

  listen(canvas) {
    canvas.addEventListener('pointermove', event => this.moved(event));
    canvas.addEventListener('pointerleave', () => {
      this.pointer = null;
      this.tip.hidden = true;
    });
    canvas.addEventListener('pointerdown', event => this.pressed(event));
    for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => (this.grabbed = null));
  }

  pressed(event) {
    if (event.button !== 0) return;
    this.pointer = [event.offsetX, event.offsetY];
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
    this.hover();
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
    const lines = target >= 0 ? this.describeTarget(target) : camera >= 0 ? this.describeCamera(camera) : null;
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
      `covered by ${k} camera${k === 1 ? '' : 's'}`, `size ${decimals(run.setup.targets[i].size, 3)} m`];
  }

  describeCamera(i) {
    const {run, frame} = this;
    const pose = run.pose(i, frame);
    const level = run.level[i][frame];
    return [`camera ${run.setup.cameras[i].name}`, `x ${metres(pose.x)}, y ${metres(pose.y)}`,
      run.online[i][frame] ? `level ${level}, radius ${decimals(pose.levels[level].radius, 3)} m` : 'not online',
      `detects ${run.detected[i][frame]} of ${run.targets[frame]} targets`];
  }

  paint(context, width, height) {
    const {run, frame} = this;
    if (this.surface.changed) {
      this.map = fit(run.setup.field, width, height, this.surface.unit);
      this.size = this.figureSize(width, height);
      this.surface.changed = false;
    }
    context.fillStyle = this.colours.paper;
    context.fillRect(0, 0, width, height);
    this.paintGrid(context, width, height);
    if (!run.count) return;
    run.setup.cameras.forEach((camera, i) => run.online[i][frame] && this.paintView(context, i));
    this.paintTrails(context);
    run.setup.cameras.forEach((camera, i) => this.paintCamera(context, i));
    run.setup.targets.forEach((target, i) => run.present[i][frame] && this.paintTarget(context, i));
    this.label();
  }

  /** How large cameras and targets are drawn: smaller where there are many. */
  figureSize(width, height) {
    const {cameras, targets} = this.run.setup;
    const room = Math.sqrt((width * height) / (cameras.length + targets.length + 1));
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
    const pose = run.pose(i, frame);
    const level = pose.levels[run.level[i][frame]];
    const chosen = i === this.selected;
    context.fillStyle = colours.range;
    context.globalAlpha = chosen ? 0.4 : 0.13;
    for (const {from, to} of level.detected) {
      context.beginPath();
      sector(context, map, pose, to);
      if (from > 0) sector(context, map, pose, from);
      context.fill('evenodd');
    }
    context.globalAlpha = chosen ? 1 : 0.55;
    context.strokeStyle = colours.range;
    context.lineWidth = (chosen ? 2.5 : 1) * this.surface.unit;
    context.setLineDash(chosen ? [] : [5 * this.surface.unit, 4 * this.surface.unit]);
    context.beginPath();
    sector(context, map, pose, level.radius);
    context.stroke();
    context.setLineDash([]);
    context.globalAlpha = 1;
  }

  paintTrails(context) {
    const {run, frame, map} = this;
    const length = Math.ceil(Math.min(TRAIL, TRAIL_SEGMENTS / run.setup.targets.length));
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

  /** A square with a short line along the heading; hollow and crossed out while it is not online. */
  paintCamera(context, i) {
    const {run, frame, map, colours} = this;
    const pose = run.pose(i, frame);
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
    const r = Math.max(9 * this.size, (map.scale * run.setup.targets[i].size) / 2);
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
      `${row.covered_0} covered by no camera, ${row.covered_1} by one, ${row.covered_k} by two or more.`);
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

/** A sector or a full circle about a camera; headings run clockwise from +y, which is upwards. */
function sector(context, map, {x, y, heading, viewingAngle}, radius) {
  const [cx, cy, r] = [map.x(x), map.y(y), map.scale * radius];
  if (viewingAngle >= 2 * Math.PI) {
    context.moveTo(cx + r, cy);
    context.arc(cx, cy, r, 0, 2 * Math.PI);
  } else {
    const along = heading - Math.PI / 2;
    context.moveTo(cx, cy);
    context.arc(cx, cy, r, along - viewingAngle / 2, along + viewingAngle / 2);
    context.closePath();
  }
}

/** 1, 2 or 5 times a power of ten, at least this much. */
function niceGap(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * [1, 2, 5, 10].find(factor => factor * power >= least);
}

function legend() {
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
    el('span', {class: 'key-range'}, 'detection range'));
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
