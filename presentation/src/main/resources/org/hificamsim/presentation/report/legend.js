// The legend of a scene. Rhino runs this file too: see scene.js.
import {hatch} from './hatch.js';
import {decimals} from './numbers.js';
import {paintObstacle} from './obstacle-layer.js';
import {COVER, DENSITY_ZONES, shape} from './palette.js';
import {BLIND_DASHES, VIEW_DASHES} from './view-layers.js';
import {hasOutlines} from './zone-layer.js';

const MOST_TRANSMITTANCES = 3;

/**
 * Returns the entries of the legend, {label, mark}, in groups. `mark(context, x, y, r)` paints an
 * entry's sign with its centre at (x, y); an entry without a mark is a heading.
 */
export const legend = ({run: {setup}, zones, colours, densityCamera, host, unit}) =>
  [
    setup.targets.length ? coverSigns(colours) : [],
    viewSigns(colours, zones),
    siteSigns(setup, colours, hatch(host, colours.shadow, unit)),
    densityCamera < 0 ? [] : densitySigns(setup.cameras[densityCamera]),
  ].filter(group => group.length);

const coverSigns = colours =>
  [{label: 'covered by'}].concat(
    COVER.map(({label, colour}, kind) => ({label, mark: coverMark(kind, colour)})),
  );

const viewSigns = (colours, zones) =>
  [
    {label: 'field of view', mark: circleMark(colours.range, VIEW_DASHES)},
    {label: 'detection range', mark: fillMark(colours.range, 0.35)},
  ].concat(hasOutlines(zones) ? [{label: 'zone', mark: squareMark(colours.accent)}] : []);

function siteSigns({obstacles = [], slow}, colours, hidden) {
  const transmittances = new Set(obstacles.map(({transmittance}) => transmittance));
  const solid = [
    {label: 'obstacle', mark: obstacleMark(0, colours)},
    {label: 'hidden from all by obstacles', mark: fillMark(hidden)},
  ];
  const transparent = Array.from(transmittances)
    .filter(share => share > 0)
    .sort((a, b) => a - b)
    .slice(0, MOST_TRANSMITTANCES)
    .map(share => ({
      label: `lets ${decimals(100 * share, 1)} % through`,
      mark: obstacleMark(share, colours),
    }));
  const moving = {label: 'moves, sees nothing', mark: circleMark(colours.range, BLIND_DASHES)};
  return (transmittances.has(0) ? solid : []).concat(transparent, slow ? [moving] : []);
}

const densitySigns = camera =>
  [{label: `${camera.name}, pixels per metre:`}].concat(
    DENSITY_ZONES.map(({name, least, colour}) => ({
      label: `${name} ${least}`,
      mark: fillMark(colour),
    })),
  );

const coverMark = (kind, colour) => (context, x, y, r) => {
  context.fillStyle = colour;
  context.beginPath();
  shape(context, kind, x, y, r);
  context.fill();
};

const circleMark = (colour, pattern) => (context, x, y, r) => {
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.setLineDash(pattern);
  context.beginPath();
  context.arc(x, y, r, 0, 2 * Math.PI);
  context.stroke();
};

const squareMark = colour => (context, x, y, r) => {
  context.strokeStyle = colour;
  context.setLineDash([0.8 * r, 0.4 * r]);
  context.strokeRect(x - r, y - r, 2 * r, 2 * r);
};

function fillMark(style, alpha = 1) {
  return (context, x, y, r) => {
    context.fillStyle = style;
    context.globalAlpha = alpha;
    context.fillRect(x - r, y - r, 2 * r, 2 * r);
  };
}

const obstacleMark = (transmittance, colours) => (context, x, y, r) => {
  context.beginPath();
  context.rect(x - r, y - r, 2 * r, 2 * r);
  paintObstacle(context, {kind: 'polygon', transmittance}, colours.wall, 1);
};
