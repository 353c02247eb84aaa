// What a field looks like in one frame of a run, layer by layer: pages paint it on their canvas, pictures on Java's ScriptCanvas.
// A new layer is a function here, its place in LAYERS and what it shows in the scene.
// Rhino runs this file as browsers do, but knows no classes, no spread arguments, and in a for loop neither const nor destructuring in its head.
import {COVER, coverClass, scaleColour, shape, ZONES} from './palette.js';
import {band, border, fillDetected, inSight, poseAt, ring, seenAt, viewAt} from './views.js';
import {decimals} from './numbers.js';
import {PARTS, partsFrom, told} from './belief.js';

const TRAIL = 40; // frames
const TRAIL_SEGMENTS = 1500;
const MARGIN = [46, 36]; // pixels, for the numbers along the borders
const ROOM = 56; // pixels a figure has about it before it shrinks
const LEGIBLE = 6; // pixels: in smaller figures no number is written
const WALL = 3;
const DOT = 2.2;
const VIEW = [5, 4]; // dashes
const BLIND = [2, 5];
const THROUGH = [6, 3];

/** How much of what is below it a heat map hides, and what no camera ever covers: as a target that none does. */
export const HEAT = 0.8;
export const NEVER = COVER[0].colour;

/** All layers, the lowest first. */
export const LAYERS = [
  floor,
  grid,
  heat,
  beliefs,
  zones,
  views,
  shadows,
  obstacles,
  tracks,
  trails,
  messages,
  cameras,
  targets,
  scaleBar,
];

/** The layers of a heat map's picture: what belongs to one step is left out. */
export const MAP_LAYERS = [floor, grid, heat, obstacles, tracks, cameras, scaleBar];

/** The layers of a plan's picture: cells in classes, what each camera looks at, and its name. */
export const PLAN_LAYERS = [floor, grid, heat, views, obstacles, cameras, names, scaleBar];

/**
 * Paints layers of a scene.
 *
 * `run`: what is shown, with `setup`, `most` (targets at the same time) and lists by camera or target and by frame; `frame`;
 * `map`: from `fit`; `unit`: pixels of a pixel, which grow with the text; `colours`: by their names in the style sheet;
 * `selected`: the chosen camera and `zoned`: the one whose pixel densities are shown, -1 for none;
 * `heat`: the record ShownFigure with `columns`, `rows` and `values`, or nothing; with `classes`, colours that the values number, it has no scale; `floor`: a list of {area, image}, `opacity` of these; `trails`: whether targets have their last steps behind them; `tracks(context)` or nothing; `belief`: as the record BeliefFrame, or nothing;
 * `host`: what each canvas does in its own way: `pattern(side, paint)`, a style for filling, `cells(columns, rows, colourOf)`, an image,
 * and `through(context, mask, style)`, which fills what `mask(canvas)` covers and leaves covered.
 */
export function paintScene(context, scene, layers = LAYERS) {
  layers.forEach(layer => {
    context.save();
    layer(context, scene);
    context.restore();
  });
}

/** Maps metres to pixels, the whole field in sight within a box, y upwards. */
export function fit({minX, maxX, minY, maxY}, width, height, unit) {
  const [across, down] = MARGIN.map(margin => 2 * margin * unit);
  const scale = Math.max(
    1e-9,
    Math.min((width - across) / (maxX - minX), (height - down) / (maxY - minY)),
  );
  const left = width / 2 - (scale * (minX + maxX)) / 2;
  const top = height / 2 + (scale * (minY + maxY)) / 2;
  return {
    scale,
    width,
    height,
    x: x => left + scale * x,
    y: y => top - scale * y,
    place: (px, py) => [(px - left) / scale, (top - py) / scale],
  };
}

/** The same map, enlarged about a place in pixels, and moved by some. */
export const magnified = ({x, y, scale, width, height, place}, times, left, top) => ({
  scale: scale * times,
  width,
  height,
  times,
  x: metres => left + times * x(metres),
  y: metres => top + times * y(metres),
  place: (px, py) => place((px - left) / times, (py - top) / times),
});

/** How high a picture is in which the field is as wide as the picture allows. */
export const heightFor = ({minX, maxX, minY, maxY}, width) =>
  2 * MARGIN[1] + (width - 2 * MARGIN[0]) * ((maxY - minY) / (maxX - minX));

/** How large cameras and targets are drawn: smaller where there are many, larger where somebody looks closer. */
export function figureSize({run, map, unit}) {
  const room =
    (map.times ?? 1) *
    Math.sqrt((map.width * map.height) / (run.setup.cameras.length + run.most + 1));
  return unit * Math.max(0.25, Math.min(1, room / (ROOM * unit)));
}

function floor(context, {map, floor, opacity}) {
  context.globalAlpha = opacity;
  floor.forEach(({area: {minX, maxX, minY, maxY}, image}) =>
    context.drawImage(
      image,
      map.x(minX),
      map.y(maxY),
      map.scale * (maxX - minX),
      map.scale * (maxY - minY),
    ),
  );
}

function grid(context, {map, colours, unit, run}) {
  const {minX, maxX, minY, maxY} = run.setup.field;
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
  context.beginPath();
  context.strokeStyle = colours.faint;
  context.rect(map.x(minX), map.y(maxY), map.x(maxX) - map.x(minX), map.y(minY) - map.y(maxY));
  context.stroke();
}

/** How long some metres are, in the lower right corner whatever part of the field is in sight. */
function scaleBar(context, {map, colours, unit}) {
  const metres = niceGap((60 * unit) / map.scale);
  const [right, bottom, length] = [
    map.width - 12 * unit,
    map.height - 6 * unit,
    map.scale * metres,
  ];
  context.fillStyle = colours.paper;
  context.globalAlpha = 0.75;
  context.fillRect(right - length - 70 * unit, bottom - 11 * unit, length + 76 * unit, 16 * unit);
  context.globalAlpha = 1;
  context.strokeStyle = context.fillStyle = colours.ink;
  context.lineWidth = 1.5 * unit;
  context.beginPath();
  [
    [0, -5],
    [0, 0],
    [-length, 0],
    [-length, -5],
  ].forEach(([dx, dy], i) => context[i ? 'lineTo' : 'moveTo'](right + dx, bottom + dy * unit));
  context.stroke();
  context.font = `${11 * unit}px sans-serif`;
  context.textAlign = 'right';
  context.fillText(`${decimals(metres, 3)} m`, right - length - 5 * unit, bottom);
}

/** 1, 2 or 5 times a power of ten, at least this much. */
function niceGap(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * [1, 2, 5, 10].find(factor => factor * power >= least);
}

const hatches = new Map();

/** A style for filling: pale ground with diagonal lines, which show on light and on dark floors. */
export function hatch(host, colour, unit) {
  const key = `${colour} ${unit}`;
  const side = Math.round(7 * unit);
  if (!hatches.has(key)) {
    hatches.set(
      key,
      host.pattern(side, tile => {
        tile.fillStyle = tile.strokeStyle = colour;
        tile.globalAlpha = 0.22;
        tile.fillRect(0, 0, side, side);
        tile.globalAlpha = 0.7;
        tile.beginPath();
        [-side, 0, side].forEach(from => {
          tile.moveTo(from, side);
          tile.lineTo(from + side, 0);
        });
        tile.stroke();
      }),
    );
  }
  return hatches.get(key);
}

/** The cells of a heat map: in colours what is above 0, hatched what is 0, nothing where there is nothing to show. */
function heat(context, {heat, map, run, unit, host}) {
  if (!heat) return;
  const {columns, rows, values, end, logarithmic, classes} = heat;
  const share = value =>
    logarithmic ? (end > 1 ? Math.log(value) / Math.log(end) : 1) : value / end;
  const {minX, maxX, minY, maxY} = run.setup.field;
  const [left, bottom, width, height] = [
    map.x(minX),
    map.y(minY),
    map.scale * (maxX - minX),
    map.scale * (maxY - minY),
  ];
  context.beginPath();
  for (let cell = 0; cell < values.length; cell++) {
    if (classes || values[cell] !== 0) continue;
    let row = Math.floor(cell / columns);
    context.rect(
      left + ((cell - row * columns) * width) / columns,
      bottom - ((1 + row) * height) / rows,
      width / columns,
      height / rows,
    );
  }
  context.fillStyle = hatch(host, NEVER, unit);
  context.fill();
  context.globalAlpha = classes ? 0.4 : HEAT;
  context.imageSmoothingEnabled = false;
  heat.image ??= host.cells(columns, rows, cell =>
    classes
      ? (classes[values[cell]] ?? null)
      : values[cell] > 0
        ? scaleColour(share(values[cell]))
        : null,
  );
  context.drawImage(heat.image, left, bottom - height, width, height);
}

/** What a camera believes: shaded where targets are expected that nobody sees; a circle in which a target is that was seen, paler the less sure. */
function beliefs(context, {belief, run, map, colours, unit}) {
  if (!belief) return;
  const {minX, maxX, minY, maxY} = run.setup.field;
  const [width, height] = [
    (map.scale * (maxX - minX)) / PARTS,
    (map.scale * (maxY - minY)) / PARTS,
  ];
  const first = partsFrom(run);
  const end = first + PARTS * PARTS;
  let most = 1e-9;
  for (let i = first; i < end; i++) most = Math.max(most, belief[i]);
  context.fillStyle = context.strokeStyle = colours.accent;
  for (let i = first; i < end; i++) {
    let [row, column] = [Math.floor((i - first) / PARTS), (i - first) % PARTS];
    context.globalAlpha = (0.5 * belief[i]) / most;
    context.fillRect(map.x(minX) + column * width, map.y(minY) - (row + 1) * height, width, height);
  }
  context.lineWidth = 1.5 * unit;
  for (let i = 0; i < first; i += 4) {
    let [px, py, radius] = [
      map.x(belief[i]),
      map.y(belief[i + 1]),
      7 * unit + map.scale * belief[i + 3],
    ];
    if (!(belief[i + 2] > 0)) continue;
    context.globalAlpha = 0.25 + 0.75 * belief[i + 2];
    context.beginPath();
    context.moveTo(px + radius, py);
    context.arc(px, py, radius, 0, 2 * Math.PI);
    context.moveTo(px - 4 * unit, py);
    context.lineTo(px + 4 * unit, py);
    context.moveTo(px, py - 4 * unit);
    context.lineTo(px, py + 4 * unit);
    context.stroke();
  }
}

/** An arrow from the selected camera to each that received its message in this step. */
function messages(context, scene) {
  const {belief, run, frame, map, colours, unit, selected} = scene;
  const said = belief && selected >= 0 && told(run, frame, selected);
  if (!said) return;
  const from = poseAt(run, selected, frame);
  context.strokeStyle = colours.accent;
  context.lineWidth = 1.2 * unit;
  context.beginPath();
  said.hearers.forEach(i => {
    const to = poseAt(run, i, frame);
    const [x, y] = [map.x(to.x), map.y(to.y)];
    const along = Math.atan2(y - map.y(from.y), x - map.x(from.x));
    const [tipX, tipY] = [x - 9 * unit * Math.cos(along), y - 9 * unit * Math.sin(along)];
    context.moveTo(map.x(from.x), map.y(from.y));
    context.lineTo(tipX, tipY);
    [along + 2.6, along - 2.6].forEach(back => {
      context.moveTo(tipX, tipY);
      context.lineTo(tipX + 9 * unit * Math.cos(back), tipY + 9 * unit * Math.sin(back));
    });
  });
  context.stroke();
}

/** The pixel density zones of a camera, each with its name where it ends. */
function zones(context, {zoned, run, frame, map, colours, unit}) {
  if (zoned < 0 || !run.online[zoned][frame] || seenAt(run, zoned, frame) < 0) return;
  const view = viewAt(run, zoned, frame);
  const reaches = ZONES.map(({least}) => view.density / least);
  inSight(context, map, view, () => {
    context.globalAlpha = 0.6;
    ZONES.forEach(({colour}, i) => {
      context.beginPath();
      band(context, map, view, i ? reaches[i - 1] : 0, reaches[i]);
      context.fillStyle = colour;
      context.fill('evenodd');
    });
    context.globalAlpha = 1;
  });
  context.fillStyle = colours.ink;
  context.strokeStyle = colours.paper;
  context.lineWidth = 3 * unit;
  context.lineJoin = 'round';
  context.font = `${11 * unit}px sans-serif`;
  context.textAlign = 'center';
  ZONES.forEach(({name, least}, i) => {
    const [x, y] = [
      map.x(view.x + reaches[i] * Math.sin(view.heading)),
      map.y(view.y + reaches[i] * Math.cos(view.heading)),
    ];
    context.strokeText(`${name} ${least}`, x, y);
    context.fillText(`${name} ${least}`, x, y);
  });
}

/** Fields of view as outlines, the ranges in which a target of the usual size is detected as areas. */
function views(context, scene) {
  const {run, frame, map, colours, unit, selected, zoned} = scene;
  context.fillStyle = context.strokeStyle = colours.range;
  onlineCameras(scene).forEach(i => {
    const blind = seenAt(run, i, frame) < 0;
    const chosen = i === selected;
    const view = viewAt(run, i, frame);
    inSight(context, map, view, () => {
      context.globalAlpha = chosen ? 0.4 : 0.13;
      if (!blind && i !== zoned && !scene.heat) fillDetected(context, map, view);
      context.globalAlpha = chosen || scene.heat ? 1 : 0.55;
      context.lineWidth = (chosen ? 2.5 : 1) * unit;
      context.setLineDash(dashes(blind ? BLIND : chosen || scene.heat ? [] : VIEW, unit));
      context.beginPath();
      border(context, map, view);
      context.stroke();
    });
  });
}

const dashes = (pattern, unit) => pattern.map(length => length * unit);

const onlineCameras = ({run, frame}) =>
  run.setup.cameras.map((camera, i) => i).filter(i => run.online[i][frame]);

/** Where some camera would detect, and walls hide it from all. */
function shadows(context, scene) {
  const {run, frame, map, colours, unit, host} = scene;
  const seeing = onlineCameras(scene)
    .filter(i => seenAt(run, i, frame) >= 0)
    .map(i => viewAt(run, i, frame));
  const cut = seeing.filter(({visible}) => visible);
  if (scene.heat || !cut.length) return;
  host.through(
    context,
    mask => {
      cut.forEach(view =>
        inSight(mask, map, {...view, visible: undefined}, () => fillDetected(mask, map, view)),
      );
      mask.globalCompositeOperation = 'destination-out';
      seeing.forEach(view => inSight(mask, map, view, () => fillDetected(mask, map, view)));
    },
    hatch(host, colours.shadow, unit),
  );
}

/** Walls, polygons and pillars; what lets light through is paler and dashed. */
function obstacles(context, scene) {
  const {run, map, colours, unit} = scene;
  const thick = Math.max(unit / 2, figureSize(scene));
  (run.setup.obstacles ?? []).forEach(obstacle => {
    context.beginPath();
    outline(context, obstacle, map);
    paintObstacle(context, obstacle, colours.wall, thick);
  });
}

/** Adds an obstacle's outline to the path. */
export function outline(path, {kind, x1, y1, x2, y2, x, y, radius, points}, map) {
  if (kind === 'wall') {
    path.moveTo(map.x(x1), map.y(y1));
    path.lineTo(map.x(x2), map.y(y2));
  } else if (kind === 'pillar') {
    path.moveTo(map.x(x + radius), map.y(y));
    path.arc(map.x(x), map.y(y), map.scale * radius, 0, 2 * Math.PI);
  } else {
    ring(
      path,
      map,
      points.flatMap(point => [point.x, point.y]),
    );
  }
}

function paintObstacle(context, {kind, transmittance}, colour, unit) {
  context.fillStyle = context.strokeStyle = colour;
  context.globalAlpha = transmittance ? 0.05 + 0.25 * (1 - transmittance) : 0.65;
  if (kind !== 'wall') context.fill();
  context.globalAlpha = 1;
  context.lineJoin = 'round';
  context.lineCap = transmittance ? 'butt' : 'round';
  context.setLineDash(transmittance ? dashes(THROUGH, unit) : []);
  context.lineWidth = (kind === 'wall' ? WALL : 1) * unit;
  context.stroke();
}

function tracks(context, scene) {
  if (!scene.tracks) return;
  context.globalAlpha = 0.5;
  scene.tracks(context);
}

/**
 * Draws where targets went from a frame on: a line from each place where one appeared, with a dot there, to where it was last seen.
 * @param every how many frames a line may pass over
 */
export function paintTracks(context, {run, map, colours, unit}, from, every = 1) {
  const dot = DOT * unit;
  context.strokeStyle = context.fillStyle = colours.ink;
  context.lineWidth = 0.9 * unit;
  run.setup.targets.forEach((target, i) => {
    const [present, x, y] = [run.present[i], run.x[i], run.y[i]];
    context.beginPath();
    for (let f = from; f < run.count; f++) {
      if (!present[f]) continue;
      let [px, py] = [map.x(x[f]), map.y(y[f])];
      if (!f || !present[f - 1]) {
        context.fillRect(px - dot, py - dot, 2 * dot, 2 * dot);
        context.moveTo(px, py);
      } else {
        if (f === from) context.moveTo(map.x(x[f - 1]), map.y(y[f - 1]));
        if (f % every === 0 || f + 1 === run.count || !present[f + 1]) context.lineTo(px, py);
      }
    }
    context.stroke();
  });
}

/** A target's last steps, in the colours and widths of how it was covered. */
function trails(context, scene) {
  if (!scene.trails) return;
  const {run, frame, map} = scene;
  const size = figureSize(scene);
  const length = Math.ceil(Math.min(TRAIL, TRAIL_SEGMENTS / run.most));
  const first = Math.max(1, frame - length + 1);
  context.lineCap = 'round';
  for (let i = 0; i < run.setup.targets.length; i++) {
    let [present, x, y] = [run.present[i], run.x[i], run.y[i]];
    for (let f = first; f <= frame; f++) {
      let line =
        present[f] &&
        present[f - 1] &&
        cut(map, [map.x(x[f - 1]), map.y(y[f - 1])], [map.x(x[f]), map.y(y[f])]);
      if (!line) continue;
      let cover = COVER[coverClass(run.coverage[i][f])];
      context.globalAlpha = 0.15 + (0.75 * (f - first + 1)) / (frame - first + 1);
      context.strokeStyle = cover.colour;
      context.lineWidth = cover.width * size;
      context.beginPath();
      context.moveTo(line[0][0], line[0][1]);
      context.lineTo(line[1][0], line[1][1]);
      context.stroke();
    }
  }
}

/** The part of a line that is in sight or near by (Liang and Barsky 1984), nothing if none is: painting a line takes as long as it is. */
function cut({width, height}, a, b) {
  let [from, to] = [0, 1];
  [
    [0, width],
    [1, height],
  ].forEach(([axis, size]) => {
    const rise = b[axis] - a[axis];
    const ends = [-size, 2 * size].map(edge =>
      rise ? (edge - a[axis]) / rise : edge < a[axis] ? -Infinity : Infinity,
    );
    from = Math.max(from, Math.min(ends[0], ends[1]));
    to = Math.min(to, Math.max(ends[0], ends[1]));
  });
  return from < to
    ? [from, to].map(share => [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])])
    : null;
}

/** A square with a short line along its view; hollow and crossed out while it is not online. */
function cameras(context, scene) {
  const {run, frame, map, colours, selected} = scene;
  const size = figureSize(scene);
  run.setup.cameras.forEach((camera, i) => {
    const {heading, viewingAngle} = viewAt(run, i, frame);
    const pose = poseAt(run, i, frame);
    const [x, y] = [map.x(pose.x), map.y(pose.y)];
    const r = (i === selected ? 7 : 5) * size;
    const online = run.online[i][frame];
    context.lineWidth = 1.5 * size;
    context.fillStyle = online ? colours.camera : colours.paper;
    context.strokeStyle = online ? colours.paper : colours.camera;
    context.beginPath();
    context.rect(x - r, y - r, 2 * r, 2 * r);
    context.fill();
    context.stroke();
    context.strokeStyle = colours.camera;
    context.beginPath();
    if (viewingAngle < 2 * Math.PI) {
      context.moveTo(x, y);
      context.lineTo(x + 2.4 * r * Math.sin(heading), y - 2.4 * r * Math.cos(heading));
    }
    if (!online) {
      context.moveTo(x - r, y - r);
      context.lineTo(x + r, y + r);
    }
    context.stroke();
  });
}

/** A camera's name behind it, where it does not look. */
function names(context, scene) {
  const {run, frame, map, colours, unit} = scene;
  const away = 9 * figureSize(scene) + 5 * unit;
  context.font = `bold ${10 * unit}px sans-serif`;
  context.textAlign = 'center';
  context.lineJoin = 'round';
  context.lineWidth = 3 * unit;
  context.strokeStyle = colours.paper;
  context.fillStyle = colours.ink;
  run.setup.cameras.forEach(({name}, i) => {
    const {heading} = viewAt(run, i, frame);
    const pose = poseAt(run, i, frame);
    const [x, y] = [
      map.x(pose.x) - away * Math.sin(heading),
      map.y(pose.y) + away * Math.cos(heading) + 4 * unit,
    ];
    context.strokeText(name, x, y);
    context.fillText(name, x, y);
  });
}

/** Each target as its cover class says, with its number of cameras; as large as it is, or as can be seen. */
function targets(context, scene) {
  const {run, frame, map, colours} = scene;
  const size = figureSize(scene);
  const {targets, widths = targets.map(target => target.size), targetSize} = run.setup;
  const alike = new Set(widths).size < 2;
  targets.forEach((target, i) => {
    if (!run.present[i][frame]) return;
    const k = run.coverage[i][frame];
    const kind = coverClass(k);
    const [x, y] = [map.x(run.x[i][frame]), map.y(run.y[i][frame])];
    const prominence = alike ? 1 : Math.max(0.6, Math.min(2, widths[i] / targetSize));
    const r = Math.max(9 * size * prominence, (map.scale * widths[i]) / 2);
    context.fillStyle = COVER[kind].colour;
    context.strokeStyle = colours.ink;
    context.lineWidth = 1.5 * size;
    context.beginPath();
    shape(context, kind, x, y, r);
    context.fill();
    context.stroke();
    if (kind > 0 && r >= LEGIBLE) {
      context.fillStyle = '#000';
      context.font = `bold ${Math.round(r * 1.15)}px sans-serif`;
      context.textAlign = 'center';
      context.fillText(k, x, y + r * (kind === 1 ? 0.55 : 0.42));
    }
  });
}

/** What the signs of a scene mean: groups of {label, mark}; `mark(context, x, y, r)` paints the sign about a place, where the label has one. */
export function legend({run: {setup}, colours, zoned, host, unit}) {
  const ringed = (colour, pattern) => (context, x, y, r) => {
    context.strokeStyle = colour;
    context.lineWidth = 1;
    context.setLineDash(pattern);
    context.beginPath();
    context.arc(x, y, r, 0, 2 * Math.PI);
    context.stroke();
  };
  const filled =
    (style, alpha = 1) =>
    (context, x, y, r) => {
      context.fillStyle = style;
      context.globalAlpha = alpha;
      context.fillRect(x - r, y - r, 2 * r, 2 * r);
    };
  const obstacle = transmittance => (context, x, y, r) => {
    context.beginPath();
    context.rect(x - r, y - r, 2 * r, 2 * r);
    paintObstacle(context, {kind: 'polygon', transmittance}, colours.wall, 1);
  };
  const covers = COVER.map(({label, colour}, kind) => ({
    label,
    mark: (context, x, y, r) => {
      context.fillStyle = colour;
      context.beginPath();
      shape(context, kind, x, y, r);
      context.fill();
    },
  }));
  const kinds = new Set((setup.obstacles ?? []).map(({transmittance}) => transmittance));
  const through = Array.from(kinds)
    .filter(part => part > 0)
    .sort((a, b) => a - b)
    .slice(0, 3);
  const site = [
    ...(kinds.has(0)
      ? [
          {label: 'obstacle', mark: obstacle(0)},
          {label: 'hidden from all by obstacles', mark: filled(hatch(host, colours.shadow, unit))},
        ]
      : []),
    ...through.map(part => ({
      label: `lets ${decimals(100 * part, 1)} % through`,
      mark: obstacle(part),
    })),
    ...(setup.slow ? [{label: 'moves, sees nothing', mark: ringed(colours.range, BLIND)}] : []),
  ];
  const dense =
    zoned < 0
      ? []
      : [
          {label: `${setup.cameras[zoned].name}, pixels per metre:`},
          ...ZONES.map(({name, least, colour}) => ({
            label: `${name} ${least}`,
            mark: filled(colour),
          })),
        ];
  return [
    [
      {label: 'covered by'},
      ...covers,
      {label: 'field of view', mark: ringed(colours.range, VIEW)},
      {label: 'detection range', mark: filled(colours.range, 0.35)},
    ],
    site,
    dense,
  ].filter(group => group.length);
}
