// Builds the page of a recorded run: its replay, figures over time, areas and numbers.
import {Controls} from './controls.js';
import {el} from './dom.js';
import {blindSpots, zoneShares} from './heat-areas.js';
import {unpackHeat} from './heat.js';
import {scoreNumber, spelled, tipped} from './names.js';
import {significant} from './numbers.js';
import {Player} from './player.js';
import {Playhead} from './playhead.js';
import {Readers} from './readers.js';
import {unpack} from './recording.js';
import {blindSpotCard, zoneCard} from './run-areas.js';
import {details} from './run-details.js';
import {thinned} from './run.js';
import {isStill} from './views.js';

const ALL_ZERO =
  'k_min is 0 at every step shown: there was always a target that no camera covered. ' +
  'The shares of targets by number of cameras say more.';

/** Builds the page from data that RunReport wrote. */
export async function runPage(root, data) {
  const {setup, runs} = data.replay;
  let controls;
  let player;
  let heatFigure = '';
  const playerBox = el('div', {class: 'single apart'});
  const curves = el('div', {class: 'curves'});
  const heat = data.heat && (await unpackHeat(data.heat));
  const showFigure = name => player.field.showHeat((heatFigure = name));
  const showSpot = spot => {
    showFigure('covered');
    player.field.showArea(spot);
    player.element.scrollIntoView({block: 'nearest'});
  };
  const blind = heat && blindSpotCard(heat, blindSpots(heat, setup.field), showSpot);
  const met = Object.fromEntries((data.zones || []).map(zone => [zone.name, zone.met]));
  const zones =
    setup.zones?.length &&
    zoneCard(setup.zones, met, heat && zoneShares(heat, setup.field, setup.zones), setup.detection);
  const {wholeRun, settings, made} = details(data);
  const tables = el('section', {class: 'details'}, wholeRun, settings, made);
  const readers = new Readers({
    planner: [playerBox, zones, blind, curves, tables],
    researcher: [curves, tables, playerBox, zones, blind],
  });

  async function open(index) {
    const run = await unpack(setup, runs[index]);
    const score = data.scores[index];
    if (score) Object.assign(run, {objective: data.objective, score});
    run.lens = data.summary.settings;
    const playhead = new Playhead(run.count, run.every);
    controls = new Controls(playhead, run);
    player = new Player(run, playhead, {
      middle: controls.element,
      heat: heat && showFigure,
      figures: heat?.figures,
    });
    if (heat) {
      player.field.loadHeat(heat);
      player.field.showHeat(heatFigure);
    }
    playerBox.replaceChildren(player.element);
    curves.replaceChildren(player.timeline.element);
    window.hificamsim = {run, playhead, player};
    // report.html#120 opens at step 120, report.html in the middle, where cameras have learned
    const step = /^#\d+$/.test(location.hash) ? Number(location.hash.slice(1)) : run.steps / 2;
    playhead.show(run.frameAt(step));
    root.dataset.ready = String(index);
    if (!run.highestKMin && data.objective.kMin) playerBox.prepend(notice(ALL_ZERO));
    if (run.every > 1) {
      const rest = ', and the last, to keep the file small. steps.csv has them all.';
      playerBox.prepend(notice(thinned(run, run.every) + rest));
    }
  }

  root.append(header(data, readers.control), answer(data), facts(data, open), readers.element);
  const keys = new Controls(new Playhead(), {count: 0, steps: 0});
  keys.actionOf = event => controls.actionOf(event);
  keys.listen();
  await open(0);
}

const notice = text => el('p', {class: 'notice'}, text);

const header = ({replay: {setup}}, reader) =>
  el(
    'header',
    {},
    el(
      'h1',
      {},
      setup.scenario,
      isStill(setup) ? null : el('small', {title: setup.policy}, spelled(setup.policy)),
    ),
    reader,
  );

/** The score of the whole run in the objective's words. */
function answer({objective, summary: {repeat, metrics, settings}}) {
  const score = metrics.score ?? metrics.performance;
  const {mean, low, high} = score;
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

/** The facts of the setup as badges, and the choice among its repeats. */
function facts({replay: {setup, runs, repeat}}, open) {
  const badges = [
    tipped(spelled(setup.detection), setup.detection),
    `${/@(chance|probability)/.test(setup.detection) ? 'half of the time at' : 'threshold'} ` +
      significant(setup.threshold),
    `${runs[0].steps} steps`,
    `${setup.cameras.length} camera${setup.cameras.length === 1 ? '' : 's'}`,
    setup.targets.length &&
      `targets move ${setup.order === 'camsim' ? 'before' : 'after'} cameras look`,
  ].filter(Boolean);
  return el(
    'div',
    {class: 'facts-of-run'},
    el('p', {class: 'badges'}, ...badges.map(badge => el('span', {}, badge))),
    repeatChooser(runs, repeat, open),
  );
}

function repeatChooser(runs, repeat, open) {
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
