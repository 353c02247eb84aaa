// The metrics and settings of a run, and the command that repeats it.
import {el} from './dom.js';
import {
  settingName,
  settingNames,
  settingOf,
  settingText,
  tipped,
  unitAfterPercent,
  withUnit,
} from './names.js';
import {isStill} from './views.js';

/** The metrics at the top of the table, in reverse order. */
const LEADING = ['score', 'mean_score'];
/** The metrics that repeat the leading ones if k_min is the objective. */
const K_MIN_METRICS = ['performance', 'mean_k_min'];
/** The metrics of cameras that move. */
const MOVE_METRICS = ['zoom_changes', 'zoom_change_rate', 'pan_travel', 'zoom_travel'];

/** Returns the elements `wholeRun`, `settings` and `made`. */
export function details({summary, names, objective, command, version, replay}) {
  const still = isStill(replay.setup);
  const repeated = summary.repeat > 1;
  const metrics = Object.entries(summary.metrics)
    .filter(([name]) => !objective.kMin || !K_MIN_METRICS.includes(name))
    .filter(([name]) => !still || !MOVE_METRICS.includes(name))
    .sort(([a], [b]) => LEADING.indexOf(b) - LEADING.indexOf(a));
  names.score.unit = scoreUnit(objective);
  names.mean_score.unit = scoreUnit(objective)
    .replace(/ ?x steps/, '')
    .replace('shares', 'share');
  const rows = metrics.map(([name, {mean, low, high}]) => {
    const text = value => withUnit(value, names[name].unit, {low, high});
    return row(
      name,
      names[name].title,
      `${name}: ${names[name].meaning}`,
      el('td', {data: {name: `summary-${name}`}}, text(mean)),
      repeated ? el('td', {}, low === high ? '' : `${text(low)} to ${text(high)}`) : null,
      el('td', {class: 'unit'}, unitAfterPercent(names[name].unit)),
    );
  });
  const settings = settingNames(summary.settings)
    .filter(name => !still || name !== 'policy')
    .filter(name => !isEmpty(summary.settings[name]))
    .flatMap(name =>
      name === 'optics'
        ? summary.settings.optics.map(opticsRow)
        : [row(name, settingName(name), name, settingCell(summary.settings, name))],
    );
  return {
    wholeRun: table(
      'Whole run',
      ['figure', ...(repeated ? ['mean of the repeats', '95 % interval'] : ['value']), 'unit'],
      rows,
    ),
    settings: table('Settings', ['setting', 'value'], settings),
    made: el(
      'div',
      {},
      el('h2', {}, 'Made with'),
      el('pre', {tabindex: 0}, command),
      el('p', {class: 'note'}, `HiFi-CamSim ${version}`),
    ),
  };
}

const isEmpty = value => value === null || (Array.isArray(value) && !value.length);

const scoreUnit = ({share, text}) =>
  share ? 'shares x steps' : text.startsWith('sum') ? 'detections' : 'cameras x steps';

/** A row of the setting `optics`, for one of the optics: its name and its values. */
const opticsRow = ({name, ...parts}) =>
  row('optics', `optics ${name}`, 'optics', el('td', {}, settingText(parts)));

/** A setting in words, with its raw value in the tooltip. */
const settingCell = (settings, name) =>
  el('td', {}, tipped(settingOf(settings, name), String(settings[name])));

export const row = (name, text, title, ...cells) =>
  el('tr', {data: {row: name}}, el('th', {scope: 'row', title}, text), ...cells);

export function table(title, columns, rows) {
  return el(
    'div',
    {tabindex: 0},
    el('h2', {}, title),
    el(
      'table',
      {},
      el('thead', {}, el('tr', {}, ...columns.map(column => el('th', {scope: 'col'}, column)))),
      el('tbody', {}, ...rows),
    ),
  );
}
