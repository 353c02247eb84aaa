// Builds the live page: one or two simulations of the same targets, stepped by the command that
// serves the page.
import {ChoiceForm} from './choice.js';
import {Controls, onKeys} from './controls.js';
import {el, setText} from './dom.js';
import {DrawForm} from './draw-form.js';
import {unpackHeat} from './heat.js';
import {LiveEdits} from './live-edits.js';
import {LivePlayhead} from './live-playhead.js';
import {scoreText} from './names.js';
import {PlanForm} from './plan-form.js';
import {Player} from './player.js';
import {Run, thinned} from './run.js';
import {ZoneList} from './zone-list.js';

const MAX_FRAMES = 8000;
const RECENT_STEPS = 100;
const SCROLLING = ['.side', '.tools'];

const LIVE_NOTE =
  'Drag a camera, or move the chosen one with W A S D and turn it with Q and E (with shift ten ' +
  'times as far). ';
const TARGETS_NOTE =
  'After a new model, policy, camera or wall the targets go on, and learning begins again.';
const PLAN_NOTE =
  '1. Set the scale: choose "scale", click both ends of a length that you know, and type it. ' +
  '2. Draw walls, shelves, and zones with what they ask for. 3. Plan the cameras, or draw them ' +
  'yourself, from where they hang to where they look. Drag them, and watch what is met. ' +
  '4. Save the scenario next to the plan.';

/** Builds the page from data that LivePage wrote. */
export async function viewPage(root, data) {
  const view = new LiveView(root, data);
  window.hificamsim = view;
  view.listen();
}

class LiveView {
  constructor(root, data) {
    this.root = root;
    this.data = data;
    this.runs = [];
    this.players = [];
    this.forms = [];
    this.figure = ''; // the figure of the heat map that is shown
    this.held = []; // the cameras whose views are chosen by hand
    this.seed = el('input', {type: 'number', id: 'seed', value: 0, step: 1, min: 0});
    this.keep = el('input', {type: 'checkbox', id: 'keep', checked: true});
    this.compareButton = el('button', {
      type: 'button',
      id: 'compare',
      class: 'simulating',
      onclick: () => this.send({command: 'compare', on: this.runs.length < 2}),
    });
    this.fault = el('p', {class: 'notice', role: 'alert', hidden: true});
    this.thinned = el('p', {class: 'notice', hidden: true});
    this.warning = el('p', {class: 'notice warning', role: 'alert', hidden: true});
    this.shares = new ZoneList();
    const status = el('p', {class: 'unseen', role: 'status'});
    this.content = el('div', {class: 'live-view'});
    root.append(
      this.header(),
      el('div', {class: 'messages'}, this.fault, this.warning, this.thinned),
      status,
      this.content,
    );
    this.edits = new LiveEdits(this, status);
    this.draw = new DrawForm(data, this.edits, outline =>
      this.players.forEach(({field}) => field.setDrawing(outline)),
    );
    this.plan = new PlanForm(command => this.send(command));
    this.playhead = new LivePlayhead(command => this.send(command));
    this.controls = new Controls(this.playhead, {count: 0, steps: 0, step: []});
    this.controls.listen();
    onKeys(event => this.edits.actionOf(event, this.camera));
    document.addEventListener('keydown', event => this.edits.onUndoKey(event));
  }

  header() {
    const {scenario, tools} = this.data;
    this.note = el('p', {class: 'note'}, tools.plan ? PLAN_NOTE : LIVE_NOTE);
    return el(
      'header',
      {class: 'live'},
      el('h1', {}, scenario, el('small', {}, 'live')),
      el(
        'p',
        {class: 'badges'},
        this.compareButton,
        ...['undo', 'redo'].map(command =>
          el('button', {type: 'button', id: command, onclick: () => this.send({command})}, command),
        ),
        el(
          'button',
          {type: 'button', id: 'restart', class: 'simulating', onclick: () => this.restart()},
          'restart',
        ),
        el('label', {class: 'simulating'}, 'with seed ', this.seed),
        el('label', {class: 'simulating'}, this.keep, ' keep changes'),
        el(
          'a',
          {
            href: 'scenario.xml',
            id: 'save',
            class: 'button',
            download: `${scenario}${tools.plan ? '' : '-edited'}.xml`,
          },
          'save scenario',
        ),
      ),
      this.note,
    );
  }

  restart() {
    this.send({
      command: 'restart',
      seed: Math.round(Number(this.seed.value)) || 0,
      keepCameras: this.keep.checked,
    });
  }

  /** Sends a command to the simulations, and shows the error if it is refused. */
  async send(command) {
    try {
      const answer = await fetch('command', {
        method: 'POST',
        headers: {'Content-Type': 'application/json'},
        body: JSON.stringify(command),
      });
      this.showFault(answer.ok ? '' : (await answer.text()).trim());
      return answer.ok;
    } catch {
      this.showFault('The command that serves this page has ended.');
      return false;
    }
  }

  showFault(text) {
    setText(this.fault, text);
    this.fault.hidden = !text;
  }

  listen() {
    const events = new EventSource('events');
    const on = (name, listener) =>
      events.addEventListener(name, event => listener(JSON.parse(event.data)));
    on('setup', setup => this.setUp(setup));
    on('steps', steps => this.addSteps(steps));
    on('heat', sides => this.loadHeat(sides));
    on('state', state => this.showState(state));
    events.onerror = () => this.showFault('The command that serves this page does not answer.');
    events.onopen = () => this.showFault('');
  }

  /** Shows new simulations, or new choices for the present ones if they are not `fresh`. */
  setUp({fresh, sides}) {
    if (fresh) {
      this.selectAdded(sides[0].setup);
      this.runs = sides.map(
        ({setup, estimated, objective}) => new Run(setup, estimated, objective),
      );
      this.playhead.count = 0;
      this.playhead.frame = 0;
    } else {
      const same = sides.every(({estimated}, i) => this.runs[i].estimated === estimated);
      sides.forEach(({setup, estimated}, i) => this.runs[i].changeSetup(setup, estimated));
      sides.forEach(({setup}, i) => this.forms[i].show(setup));
      if (same) return;
    }
    this.build(fresh);
  }

  /**
   * Builds the players, and new forms only for new simulations: the user may be typing in a form.
   */
  build(fresh) {
    const focused = this.content.querySelector('.tools :focus');
    const scrolled = SCROLLING.map(name => this.content.querySelector(name)?.scrollTop ?? 0);
    this.playhead.listeners = [];
    this.controls.run = this.runs[0];
    this.playhead.subscribe(frame => this.controls.show(frame));
    if (fresh) this.forms = this.runs.map((run, side) => this.form(run, side));
    this.players = this.runs.map((run, side) => this.player(run, side));
    this.players.forEach(({field}) => field.setDrawing(this.draw.outline));
    if (this.runs[0].setup.cameras.length) this.selectTogether();
    const hasTargets = this.runs[0].setup.targets.length > 0;
    this.root.classList.toggle('untargeted', !hasTargets);
    if (!this.data.tools.plan) setText(this.note, LIVE_NOTE + (hasTargets ? TARGETS_NOTE : ''));
    this.showZones(this.zones);
    this.showHeat(this.figure);
    if (fresh) this.buildColumns();
    this.columns.forEach((column, i) => {
      column.querySelector('.player')?.remove();
      column.append(this.players[i].element);
    });
    focused?.focus(); // restores the focus, which moving an element to a new player removes
    SCROLLING.forEach((name, i) => (this.content.querySelector(name).scrollTop = scrolled[i]));
    setText(
      this.compareButton,
      this.runs.length > 1 ? 'one model only' : 'second model next to it',
    );
    this.refresh();
  }

  /** Builds a column for each simulation; two columns share the controls above them. */
  buildColumns() {
    const pair = this.runs.length > 1;
    this.columns = this.forms.map(form => el('section', {class: 'column'}, form.element));
    this.content.replaceChildren(
      pair ? this.controls.element : '',
      el('div', {class: pair ? 'pair' : 'single'}, ...this.columns),
    );
  }

  player(run, side) {
    return new Player(run, this.playhead, {
      edit: this.edits,
      draw: this.draw,
      tools: side ? [] : [this.draw.element, this.plan.element, this.shares.element],
      ceiling: () => Math.max(...this.runs.map(({highestKMin}) => highestKMin)),
      heat: figure => this.chooseHeat(figure),
      figures: this.data.figures,
      middle: this.runs.length > 1 ? null : this.controls.element,
    });
  }

  form(run, side) {
    const form = new ChoiceForm(this.data, choice => this.choose(side, choice));
    form.show(run.setup);
    return form;
  }

  /** Sends a choice to a simulation; if it is refused, the form shows the old one again. */
  async choose(side, choice) {
    if (!(await this.send({command: 'choose', side, ...choice})))
      this.forms[side]?.show(this.runs[side].setup);
  }

  /** Makes a selection in one simulation select the same camera in the other. */
  selectTogether() {
    const selections = this.players.map(player => player.select.bind(player));
    const selectInAll = camera => {
      if (camera >= 0) this.camera = camera;
      selections.forEach(select => select(camera));
    };
    this.players.forEach(player => (player.select = selectInAll));
    const exists = this.camera in this.runs[0].setup.cameras;
    selectInAll(exists ? this.camera : this.players[0].agent.camera);
  }

  /** Selects a camera that has just been added, or else keeps the selection. */
  selectAdded({cameras}) {
    const before = this.runs[0]?.setup.cameras.map(({name}) => name);
    if (!before) return;
    const added = cameras.findIndex(({name}) => !before.includes(name));
    this.camera = added >= 0 ? added : cameras.findIndex(({name}) => name === before[this.camera]);
  }

  addSteps(steps) {
    for (const {sides} of steps)
      sides.forEach(({frame, moves, score}, i) => this.runs[i].push(frame, moves, score));
    if (this.runs[0].count > MAX_FRAMES) this.runs.forEach(run => run.thin());
    this.refresh();
  }

  /** Draws what has arrived, at most once for each frame of the browser. */
  refresh() {
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = null;
      this.playhead.grow(this.runs[0].count);
      this.players.forEach(player => player.grew());
      this.runs.forEach((run, i) => this.forms[i].showMean(meanScore(run)));
      this.showThinned(this.runs[0]);
      if (this.runs[0].count) this.root.dataset.ready = '';
    });
  }

  /** Says which steps are shown; the gaps are largest between the first ones. */
  showThinned(run) {
    const every = run.count > 1 ? run.step[1] - run.step[0] : 1;
    this.thinned.hidden = every === 1;
    if (every > 1)
      setText(this.thinned, `${thinned(run, every)} of the first ones, and all of the last.`);
  }

  /** Shows the heat maps of the simulations, unless the players have changed since. */
  async loadHeat(sides) {
    const {players} = this;
    const maps = await Promise.all(sides.map(unpackHeat));
    if (players === this.players && maps.length === players.length)
      maps.forEach((heat, i) => players[i].field.loadHeat(heat));
  }

  /** Shows a figure of the heat map; the simulations record a map only while one is shown. */
  chooseHeat(figure) {
    if (!figure !== !this.figure) this.send({command: 'heat', on: Boolean(figure)});
    this.showHeat(figure);
  }

  showHeat(figure) {
    this.figure = figure;
    this.players.forEach(player => player.field.showHeat(figure));
  }

  showState(state) {
    this.playhead.update(state);
    this.held = state.held ?? [];
    if (this.figure && this.heated && !state.heat) this.showHeat(''); // another page turned it off
    this.heated = Boolean(state.heat);
    this.players.forEach(player => player.agent.show(this.playhead.frame));
    this.showZones(state.zones);
    this.plan.show(state.plan, state.mountHeight);
    if (document.activeElement !== this.seed) this.seed.value = String(state.seed);
    if (state.fault) this.showFault(state.fault);
    this.warning.hidden = !state.warning;
    setText(this.warning, state.warning ?? '');
    const plays = this.runs[0]?.setup.targets.length;
    if (!this.started && plays && state.next <= 1 && !state.running) this.playhead.play();
    this.started = true;
  }

  /** Shows the zones, records ShownZone, with the share of each that is met. */
  showZones(zones = []) {
    this.zones = zones;
    this.shares.show(zones);
    this.draw.listDrawn(
      this.runs[0]?.setup.obstacles ?? [],
      zones.filter(({points}) => points.length),
    );
    this.players.forEach(({field}) => field.set('zones', zones));
  }

  /** Shows a camera in another pose in all simulations at once. */
  previewPose(camera, change) {
    this.playhead.show(this.playhead.count - 1);
    this.runs.forEach(run => run.preview(camera, change));
    this.players.forEach(player => player.show(this.playhead.frame));
  }
}

/** The mean score of the last steps in words, empty if it is not known. */
function meanScore(run) {
  const scores = run.score.slice(-RECENT_STEPS);
  if (!scores.length) return '';
  const mean = scores.reduce((sum, score) => sum + score, 0) / scores.length;
  return `${scoreText(mean, run.objective)}, the mean of the last ${scores.length} steps`;
}
