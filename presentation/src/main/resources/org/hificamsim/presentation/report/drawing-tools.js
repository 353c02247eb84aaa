// The tools that draw a site: what each asks for, the outline that it draws between two places, and
// the command that it sends.
import {el} from './dom.js';
import {degrees, rounded} from './pose-form.js';

const SHELF_HEIGHT = 1.8; // metres

const number = (name, label, attributes = {}) => ({
  label,
  input: el('input', {type: 'number', step: 'any', name, ...attributes}),
});

const choice = (name, label, options) => ({
  label,
  input: el('select', {name}, ...options.map(({value, text}) => el('option', {value}, text))),
});

/** The number in an input; null if it is empty. */
const numberIn = ({input}) => (input.value.trim() === '' ? null : Number(input.value));

const ends = ([x1, y1, x2, y2]) => ({x1, y1, x2, y2});

/** An obstacle of a height, which is empty if nobody looks over it. */
function obstacle(name, outline, height) {
  const heightInput = number('height', 'height, m', {min: 0, value: height, placeholder: 'any'});
  return {
    name,
    outline,
    inputs: [heightInput],
    command: places => ({
      command: 'draw',
      shape: name.toUpperCase(),
      ...ends(places),
      height: numberIn(heightInput),
    }),
  };
}

function zone(levels) {
  const name = {label: 'name', input: el('input', {name: 'zone', placeholder: 'zone-1'})};
  const level = choice(
    'level',
    'sees',
    levels.map(({name: value, label: text}) => ({value, text})),
  );
  const k = number('k', 'by cameras', {min: 1, step: 1, value: 1});
  const facing = number('facing', 'faces look to, °', {placeholder: 'any'});
  const depression = number('depression', 'seen from at most, ° above', {placeholder: 'any'});
  return {
    name: 'zone',
    outline: 'rectangle',
    inputs: [name, level, k, facing, depression],
    command: places => ({
      command: 'addzone',
      ...ends(places),
      zone: {
        name: name.input.value.trim(),
        detection: level.input.value,
        k: numberIn(k),
        facing: numberIn(facing),
        maxDepression: numberIn(depression),
      },
    }),
  };
}

function camera(kinds) {
  const kind = choice(
    'kind',
    'kind',
    kinds.map(value => ({value, text: value})),
  );
  const angle = number('angle', 'set to, °', {min: 0, placeholder: 'widest'});
  return {
    name: 'camera',
    outline: 'line',
    inputs: [kind, angle],
    command: ([x, y, towardsX, towardsY]) => ({
      command: 'mount',
      mount: {
        kind: kind.input.value,
        x,
        y,
        heading: rounded(degrees(Math.atan2(towardsX - x, towardsY - y))),
        angle: numberIn(angle),
      },
    }),
  };
}

/** Sets how long a line on the plan is; it waits until somebody has typed that. */
function scale() {
  const metres = number('metres', 'is as long as, m', {min: 0});
  return {
    name: 'scale',
    outline: 'line',
    inputs: [metres],
    asks: metres.input,
    command: places => ({command: 'scale', ...ends(places), metres: numberIn(metres) ?? 0}),
  };
}

/**
 * All tools, each with a `name`, the `outline` between two places (`line`, `rectangle` or
 * `circle`), `inputs`, and `command(places)` for x and y of both places in turn. One that `asks`
 * has an input that is filled in after the second place.
 *
 * @param levels of zones, {name, label}
 * @param tools the record DrawingTools
 */
export const drawingTools = ({levels, tools: {kinds, plan}}) => [
  ...(plan ? [scale()] : []),
  obstacle('wall', 'line'),
  obstacle('shelf', 'rectangle', SHELF_HEIGHT),
  obstacle('pillar', 'circle'),
  zone(levels),
  camera(kinds),
];
