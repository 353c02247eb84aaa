// The page of one run that was recorded: its replay, with a choice among the repeats.
import {el} from './dom.js';
import {thinned} from './run.js';
import {unpack} from './recording.js';
import {Playhead} from './playhead.js';
import {Controls} from './controls.js';
import {Player} from './player.js';
import {blindSpots, unpackHeat, zoneShares} from './heat.js';
import {Readers} from './readers.js';
import {besideUnit, held, scoreNumber, spelled, tipped, told, withUnit, words} from './names.js';
import {decimals, percent} from './numbers.js';

const SPOTS = 5;

/** The page; `data` is what RunReport wrote. */
export async function runPage(root, data) {
  const {setup, runs} = data.replay;
  let controls;
  let player;
  let figure = '';
  const place = el('div', {class: 'single apart'});
  const curves = el('div', {class: 'curves'});
  const heat = data.heat && (await unpackHeat(data.heat));
  const blind =
    heat &&
    blindCard(heat, setup.field, spot => {
      player.field.showHeat((figure = 'covered'));
      player.field.showArea(spot);
      player.element.scrollIntoView({block: 'nearest'});
    });
  const {whole, settings, made} = details(data);
  const zones =
    heat &&
    setup.zones?.length &&
    zoneCard(zoneShares(heat, setup.field, setup.zones), setup.detection);
  const tables = el('section', {class: 'details'}, whole, settings, made);
  const readers = new Readers({
    planner: [place, zones, blind, curves, tables],
    researcher: [curves, tables, place, zones, blind],
  });

  async function open(index) {
    const run = await unpack(setup, runs[index]);
    Object.assign(
      run,
      data.scores[index] && {objective: data.objective, score: data.scores[index]},
    );
    run.lens = data.summary.settings;
    const playhead = new Playhead(run.count, run.every);
    controls = new Controls(playhead, run);
    const chosen = name => player.field.showHeat((figure = name));
    player = new Player(run, playhead, {
      middle: controls.element,
      heat: heat && chosen,
      figures: heat?.figures,
    });
    if (heat) {
      player.field.loadHeat(heat);
      player.field.showHeat(figure);
    }
    place.replaceChildren(player.element);
    curves.replaceChildren(player.timeline.element);
    window.hificamsim = {run, playhead, player};
    playhead.show(run.frameAt(Number(location.hash.slice(1)) || 0)); // report.html#120 opens at step 120
    root.dataset.ready = String(index);
    if (!run.highest && data.objective.kMin)
      place.prepend(
        el(
          'p',
          {class: 'notice'},
          'k_min is 0 at every step shown: there was always a target that no camera covered. The shares of targets by number of cameras say more.',
        ),
      );
    if (run.every > 1)
      place.prepend(
        el(
          'p',
          {class: 'notice'},
          `${thinned(run, run.every)}, and the last, so that the file stays small. steps.csv has them all.`,
        ),
      );
  }

  root.append(
    header(data, readers.control),
    answer(data),
    facts(data, index => open(index)),
    readers.element,
  );
  const keys = new Controls(new Playhead(), {count: 0, steps: 0});
  keys.action = event => controls.action(event);
  keys.listen();
  await open(0);
}

const header = ({replay: {setup}}, reader) =>
  el(
    'header',
    {},
    el('h1', {}, setup.scenario, el('small', {title: setup.policy}, spelled(setup.policy))),
    reader,
  );

/** What the score was found under. */
function facts({replay: {setup, runs, repeat}}, open) {
  const facts = [
    tipped(spelled(setup.detection), setup.detection),
    `${/@(chance|probability)/.test(setup.detection) ? 'half of the time at' : 'threshold'} ${decimals(setup.threshold, 6)}`,
    `${runs[0].steps} steps`,
    `${setup.cameras.length} camera${setup.cameras.length === 1 ? '' : 's'}`,
    `targets move ${setup.order === 'camsim' ? 'before' : 'after'} cameras look`,
  ];
  return el(
    'div',
    {class: 'facts-of-run'},
    el('p', {class: 'badges'}, ...facts.map(fact => el('span', {}, fact))),
    chooser(runs, repeat, open),
  );
}

/** The score of the whole run in the objective's words, which is what was asked for. */
function answer({objective, summary: {repeat, metrics, settings}}) {
  const score = metrics.score ?? metrics.performance;
  const {mean, low, high} = {mean: score.mean, ...held('score', '', score)};
  const number = sum => scoreNumber(sum / settings.steps, objective);
  const interval =
    repeat > 1 && low !== high
      ? ` (95 % interval ${number(low)} to ${number(high)}, ${repeat} repeats)`
      : '';
  return el(
    'p',
    {class: 'answer'},
    el('b', {data: {name: 'score-of-run'}}, number(mean)),
    ' ',
    tipped(objective.title, objective.text),
    `, the mean of ${settings.steps} steps${interval}`,
  );
}

/** Where no camera ever looked. */
function blindCard(heat, field, show) {
  const spots = blindSpots(heat, field);
  const entry = spot =>
    el(
      'li',
      {},
      el(
        'button',
        {type: 'button', onclick: () => show(spot)},
        `${decimals(spot.area, spot.area < 10 ? 1 : 0)} m² around (${decimals((spot.minX + spot.maxX) / 2, 1)}, ${decimals((spot.minY + spot.maxY) / 2, 1)})`,
      ),
    );
  return el(
    'section',
    {class: 'card blind-spots'},
    el('h2', {}, 'Blind spots'),
    el(
      'p',
      {},
      `Of the area ${percent(heat.areaCovered)} is covered by one or more cameras in the mean of the steps, ${percent(heat.areaCoveredK)} by two or more; ${percent(heat.areaBlind)} never is.`,
    ),
    spots.length ? el('ol', {}, ...spots.slice(0, SPOTS).map(entry)) : null,
    spots.length > SPOTS
      ? el(
          'p',
          {class: 'note'},
          `The largest ${SPOTS} of ${spots.length}; hatched on the heat map.`,
        )
      : null,
  );
}

/** What each zone asks for, and what it got; of the shares, that by as many cameras as it asks for is bold. */
function zoneCard(shares, detection) {
  const others = shares.some(({zone}) => zone.detection !== detection);
  const cell = (share, bold) =>
    el('td', {}, Number.isNaN(share) ? '–' : bold ? el('b', {}, percent(share)) : percent(share));
  const card = table(
    'Zones',
    ['zone', 'asks for', 'by one or more cameras', 'by two or more', 'never'],
    shares.map(({zone, covered, twice, never}) =>
      row(
        zone.name,
        zone.name,
        zone.name,
        el(
          'td',
          {},
          `${zone.k} camera${zone.k === 1 ? '' : 's'}, `,
          tipped(spelled(zone.detection), zone.detection),
        ),
        cell(covered, zone.k === 1),
        cell(twice, zone.k === 2),
        cell(never),
      ),
    ),
  );
  card.className = 'card zones';
  card.append(
    el(
      'p',
      {class: 'note'},
      'Shares of the zone’s area, in the mean of the steps',
      others
        ? `, all by the run’s ${spelled(detection)}: place --verify has them by what each zone asks for.`
        : '.',
    ),
  );
  return card;
}

function chooser(runs, repeat, open) {
  if (repeat === 1) return el('p', {class: 'badges'}, el('span', {}, `seed ${runs[0].seed}`));
  const select = el(
    'select',
    {id: 'run', onchange: () => open(Number(select.value))},
    ...runs.map((run, i) => el('option', {value: i}, `${run.run} (seed ${run.seed})`)),
  );
  return el(
    'p',
    {class: 'chooser'},
    el('label', {for: 'run'}, 'repeat '),
    select,
    ` of ${repeat}` +
      (runs.length < repeat
        ? `; the first ${runs.length} are in this file, the others did not fit`
        : ''),
  );
}

/** The whole run in numbers, and how to do it again. */
function details({summary, names, objective, command, version}) {
  const repeated = summary.repeat > 1;
  const metrics = Object.entries(summary.metrics).sort(
    ([a], [b]) => (b === 'score') - (a === 'score'),
  );
  names.score.unit = objective.share
    ? 'shares x steps'
    : objective.text.startsWith('sum')
      ? 'detections'
      : 'cameras x steps';
  const shown = metrics.map(([name, one]) => [
    name,
    {...one, ...held(name, names[name].unit, one)},
  ]);
  const rows = shown.map(([name, {mean, low, high}]) =>
    row(
      name,
      names[name].title,
      `${name}: ${names[name].meaning}`,
      el('td', {data: {name: `summary-${name}`}}, withUnit(mean, names[name].unit)),
      repeated
        ? el(
            'td',
            {},
            low === high
              ? ''
              : `${withUnit(low, names[name].unit)} to ${withUnit(high, names[name].unit)}`,
          )
        : null,
      el('td', {class: 'unit'}, besideUnit(names[name].unit)),
    ),
  );
  const settings = Object.entries(summary.settings).flatMap(([name, value]) =>
    name === 'optics'
      ? value.map(opticsRow)
      : [row(name, words(name), name, settingCell(name, value))],
  );
  return {
    whole: table(
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

/** A kind of optics: its name, and what else the summary says of it. */
const opticsRow = ({name, ...parts}) =>
  row('optics', `optics ${name}`, 'optics', el('td', {}, told(parts)));

/** What is written as an option is read in words, with the option in the tooltip. */
const settingCell = (name, value) =>
  el(
    'td',
    {},
    /^(detection|policy|objective)$/.test(name) ? tipped(spelled(value), value) : told(value),
  );

const row = (name, text, title, ...cells) =>
  el('tr', {data: {row: name}}, el('th', {scope: 'row', title}, text), ...cells);

function table(title, columns, rows) {
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
