// The tools that draw a site: the inputs of each, the outline that it draws between two ends, and
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

const coordinates = ([x1, y1, x2, y2]) => ({x1, y1, x2, y2});

/** A tool that draws an obstacle. Without a height, no camera looks over it. */
function obstacle(name, outline, height) {
  const heightInput = number('height', 'height, m', {min: 0, value: height, placeholder: 'any'});
  return {
    name,
    outline,
    inputs: [heightInput],
    command: ends => ({
      command: 'draw',
      shape: name.toUpperCase(),
      ...coordinates(ends),
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
    command: ends => ({
      command: 'addzone',
      ...coordinates(ends),
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

/**
 * A tool that sets the scale: after a line on the plan is drawn, it asks for the length in
 * metres.
 */
function scale() {
  const metres = number('metres', 'is as long as, m', {min: 0});
  return {
    name: 'scale',
    outline: 'line',
    inputs: [metres],
    focusedInput: metres.input,
    command: ends => ({command: 'scale', ...coordinates(ends), metres: numberIn(metres) ?? 0}),
  };
}

/**
 * Returns all tools. Each has a `name`, the `outline` between two ends (`line`, `rectangle` or
 * `circle`), `inputs`, and `command(ends)`, where `ends` are x1, y1, x2 and y2 in metres. A tool
 * with a `focusedInput` waits, after its outline is drawn, until that input is filled in.
 *
 * @param levels the levels that zones can ask for, {name, label}
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
