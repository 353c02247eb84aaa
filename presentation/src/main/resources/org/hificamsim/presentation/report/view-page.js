// The live page: one or two simulations of the same targets, stepped by the command that serves it.
import {el, say} from './dom.js';
import {Run, thinned} from './run.js';
import {Controls, onKeys} from './controls.js';
import {Player} from './player.js';
import {LivePlayhead} from './live-playhead.js';
import {ChoiceForm} from './choice.js';
import {degrees, tidy} from './pose-form.js';
import {located} from './site.js';
import {unpackHeat} from './heat.js';
import {viewName} from './views.js';
import {scoreText} from './names.js';
import {decimals} from './numbers.js';

const MAX_FRAMES = 8000;
const RECENT = 100;
const NUDGE = 0.01; // of the field's longer side
const TURN = 3; // degrees
const APART = 5; // nudges between a camera and the one that is added

/** Keys that move the chosen camera: to the right and up, in nudges; and those that turn it, clockwise. */
const MOVES = {KeyW: [0, 1], KeyA: [-1, 0], KeyS: [0, -1], KeyD: [1, 0]};
const TURNS = {KeyQ: -TURN, KeyE: TURN};

/** The page; `data` is what LivePage wrote. */
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
    this.seed = el('input', {type: 'number', id: 'seed', value: 0, step: 1, min: 0});
    this.keep = el('input', {type: 'checkbox', id: 'keep', checked: true});
    this.twice = el('button', {
      type: 'button',
      id: 'compare',
      onclick: () => this.send({command: 'compare', on: this.runs.length < 2}),
    });
    this.fault = el('p', {class: 'notice', role: 'alert', hidden: true});
    this.thinned = el('p', {class: 'notice', hidden: true});
    this.warning = el('p', {class: 'notice warning', role: 'alert', hidden: true});
    this.said = el('p', {class: 'unseen', role: 'status'});
    this.shares = el('p', {class: 'note shares', hidden: true}); // not a status: it changes while a camera is dragged
    this.pending = new Map();
    this.figure = ''; // of the heat map
    this.held = []; // cameras whose views are chosen by hand
    this.place = el('div', {class: 'live-view'});
    root.append(
      this.header(),
      el('div', {class: 'messages'}, this.fault, this.warning, this.thinned),
      this.shares,
      this.said,
      this.place,
    );
    this.playhead = new LivePlayhead(command => this.send(command));
    this.controls = new Controls(this.playhead, {count: 0, steps: 0, step: []});
    this.controls.listen();
    onKeys(event => this.keyed(event));
    document.addEventListener('keydown', event => this.keyedBack(event));
  }

  header() {
    return el(
      'header',
      {class: 'live'},
      el('h1', {}, this.data.scenario, el('small', {}, 'live')),
      el(
        'p',
        {class: 'badges'},
        this.twice,
        ...['undo', 'redo'].map(command =>
          el('button', {type: 'button', id: command, onclick: () => this.send({command})}, command),
        ),
        el('button', {type: 'button', id: 'restart', onclick: () => this.restart()}, 'restart'),
        el('label', {}, 'with seed ', this.seed),
        el('label', {}, this.keep, ' keep changes'),
        el(
          'a',
          {
            href: 'scenario.xml',
            id: 'save',
            class: 'button',
            download: `${this.data.scenario}-edited.xml`,
          },
          'save scenario',
        ),
      ),
      el(
        'p',
        {class: 'note'},
        'Drag a camera, or move the chosen one with W A S D and turn it with Q and E (with shift ten times as far). ' +
          'After a new model, policy, camera or wall the targets go on, and learning begins again.',
      ),
    );
  }

  restart() {
    this.send({
      command: 'restart',
      seed: Math.round(Number(this.seed.value)) || 0,
      keepCameras: this.keep.checked,
    });
  }

  /** Has a command done; what is wrong with it is shown on the page. */
  async send(command) {
    try {
      const answer = await fetch('command', {
        method: 'POST',
        headers: {'Content-Type': 'application/json'},
        body: JSON.stringify(command),
      });
      this.tell(answer.ok ? '' : (await answer.text()).trim());
      return answer.ok;
    } catch {
      this.tell('The command that serves this page has ended.');
      return false;
    }
  }

  tell(fault) {
    say(this.fault, fault);
    this.fault.hidden = !fault;
  }

  listen() {
    const events = new EventSource('events');
    events.addEventListener('setup', event => this.setup(JSON.parse(event.data)));
    events.addEventListener('steps', event => this.push(JSON.parse(event.data)));
    events.addEventListener('heat', event => this.heat(JSON.parse(event.data)));
    events.addEventListener('state', event => this.state(JSON.parse(event.data)));
    events.onerror = () => this.tell('The command that serves this page does not answer.');
    events.onopen = () => this.tell('');
  }

  /** Other simulations, or other choices for the ones that go on. */
  setup({fresh, sides}) {
    if (fresh) {
      this.chooseAdded(sides[0].setup);
      this.runs = sides.map(
        ({setup, estimated, objective}) => new Run(setup, estimated, objective),
      );
      this.playhead.count = 0;
      this.playhead.frame = 0;
    } else {
      const same = sides.every(({estimated}, i) => this.runs[i].estimated === estimated);
      sides.forEach(({setup, estimated}, i) => this.runs[i].become(setup, estimated));
      sides.forEach(({setup}, i) => this.forms[i].show(setup));
      if (same) return;
    }
    this.build(fresh);
  }

  /** Makes the players again; the forms too, unless the simulations go on: somebody may be typing. */
  build(fresh) {
    const pair = this.runs.length > 1;
    const at = this.place.querySelector('.walls :focus');
    this.playhead.listeners = [];
    this.controls.run = this.runs[0];
    this.playhead.subscribe(frame => this.controls.show(frame));
    if (fresh) this.forms = this.runs.map((run, side) => this.form(run, side));
    const edit = {
      move: (camera, x, y) => this.move(camera, x, y),
      turn: (camera, heading) => this.turn(camera, heading),
      add: camera => this.add(camera),
      hold: (camera, view) => this.hold(camera, view),
      held: camera => this.held.includes(camera),
      suggest: camera => this.suggest(camera),
      wall: (...ends) => this.wall(...ends),
      remove: obstacle => this.remove(obstacle),
      removeCamera: camera =>
        this.removeNamed('camera', this.runs[0].setup.cameras[camera], {
          command: 'removecamera',
          camera,
        }),
      removeTarget: target =>
        this.removeNamed('target', this.runs[0].setup.targets[target], {
          command: 'removetarget',
          target,
        }),
    };
    const ceiling = () => Math.max(...this.runs.map(run => run.highest));
    this.players = this.runs.map(
      run =>
        new Player(run, this.playhead, {
          edit,
          ceiling,
          heat: figure => this.chooseHeat(figure),
          figures: this.data.figures,
          middle: pair ? null : this.controls.element,
        }),
    );
    this.selectTogether();
    this.showHeat(this.figure);
    if (fresh)
      this.columns = this.forms.map(form => el('section', {class: 'column'}, form.element));
    this.columns.forEach((column, i) => {
      column.querySelector('.player')?.remove();
      column.append(this.players[i].element);
    });
    if (fresh)
      this.place.replaceChildren(
        pair ? this.controls.element : '',
        el('div', {class: pair ? 'pair' : 'single'}, ...this.columns),
      );
    if (at)
      this.place
        .querySelector(`.walls ${at.name ? `[name=${at.name}]` : `.${at.className}`}`)
        ?.focus();
    say(this.twice, pair ? 'one model only' : 'second model next to it');
    this.refresh();
  }

  form(run, side) {
    const form = new ChoiceForm(this.data, choice => this.choose(side, choice));
    form.show(run.setup);
    return form;
  }

  /** Has a simulation go on under another choice; where that is refused, the form says again what it runs under. */
  async choose(side, choice) {
    if (!(await this.send({command: 'choose', side, ...choice})))
      this.forms[side]?.show(this.runs[side].setup);
  }

  /** A camera that is chosen in one simulation is chosen in the other. */
  selectTogether() {
    const own = this.players.map(player => player.select.bind(player));
    const all = camera => {
      if (camera >= 0) this.camera = camera;
      own.forEach(select => select(camera));
    };
    this.players.forEach(player => (player.select = all));
    all(this.camera in this.runs[0].setup.cameras ? this.camera : this.players[0].agent.camera);
  }

  push(steps) {
    for (const {sides} of steps)
      sides.forEach(({frame, moves, score}, i) => this.runs[i].push(frame, moves, score));
    if (this.runs[0].count > MAX_FRAMES) this.runs.forEach(run => run.thin());
    this.refresh();
  }

  /** Draws what has arrived, once for all that arrives before the next picture. */
  refresh() {
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = null;
      this.playhead.grow(this.runs[0].count);
      this.players.forEach(player => player.grew());
      this.runs.forEach((run, i) => this.forms[i].recent(meanScore(run)));
      this.tellThinned(this.runs[0]);
      if (this.runs[0].count) this.root.dataset.ready = '';
    });
  }

  /** What the simulations have found out of the cells, side by side. */
  async heat(sides) {
    const {players} = this;
    const maps = await Promise.all(sides.map(unpackHeat));
    if (players === this.players && maps.length === players.length)
      maps.forEach((heat, i) => players[i].field.loadHeat(heat));
  }

  /** Shows a figure of the heat map in all simulations, which find it out as long as somebody looks. */
  chooseHeat(figure) {
    if (!figure !== !this.figure) this.send({command: 'heat', on: Boolean(figure)});
    this.showHeat(figure);
  }

  showHeat(figure) {
    this.figure = figure;
    this.players.forEach(player => player.field.showHeat(figure));
  }

  /** The first steps are the ones that lie furthest apart. */
  tellThinned(run) {
    const every = run.count > 1 ? run.step[1] - run.step[0] : 1;
    this.thinned.hidden = every === 1;
    if (every > 1)
      say(this.thinned, `${thinned(run, every)} of the first ones, and all of the last.`);
  }

  state(state) {
    this.playhead.told(state);
    this.held = state.held ?? [];
    if (this.figure && this.heated && !state.heat) this.showHeat(''); // another page does without it
    this.heated = Boolean(state.heat);
    this.players.forEach(player => player.agent.show(this.playhead.frame));
    this.shares.hidden = !state.shares;
    const shares = (state.shares ?? []).map(
      ({zone, met}) => `${decimals(100 * met, 1)} % of ${zone}`,
    );
    say(this.shares, `The cameras can see ${shares.join(', ')}`);
    if (document.activeElement !== this.seed) this.seed.value = String(state.seed);
    if (state.fault) this.tell(state.fault);
    this.warning.hidden = !state.warning;
    say(this.warning, state.warning ?? '');
    if (!this.started && state.next <= 1 && !state.running) this.playhead.play();
    this.started = true;
  }

  /** A camera that has just been added is the chosen one; any other stays what it was. */
  chooseAdded({cameras}) {
    const before = this.runs[0]?.setup.cameras.map(({name}) => name);
    if (!before) return;
    const added = cameras.findIndex(({name}) => !before.includes(name));
    this.camera = added >= 0 ? added : cameras.findIndex(({name}) => name === before[this.camera]);
  }

  /** The last pose of a camera that is known, with what has been asked for since. */
  pose(camera) {
    return this.runs[0].poses[camera].at(-1).pose;
  }

  /** What a key asks for: the chosen camera elsewhere or turned. */
  keyed({code, shiftKey}) {
    const {camera} = this;
    if (!(camera in (this.runs[0]?.poses ?? []))) return null;
    const pose = this.pose(camera);
    const by = shiftKey ? 10 : 1;
    if (code in TURNS) return () => this.turn(camera, degrees(pose.heading) + by * TURNS[code]);
    if (!(code in MOVES)) return null;
    const [right, up] = MOVES[code].map(nudges => by * nudges * this.nudge());
    return () => this.move(camera, pose.x + right, pose.y + up);
  }

  nudge() {
    const {minX, maxX, minY, maxY} = this.runs[0].setup.field;
    return NUDGE * Math.max(maxX - minX, maxY - minY);
  }

  /** A place in the field, to the millimetre, as near as there is one. */
  inField(x, y) {
    const {minX, maxX, minY, maxY} = this.runs[0].setup.field;
    return {x: Math.min(Math.max(tidy(x), minX), maxX), y: Math.min(Math.max(tidy(y), minY), maxY)};
  }

  move(camera, toX, toY) {
    const place = this.inField(toX, toY);
    this.preview(camera, place);
    this.edit({command: 'drag', camera, ...place});
  }

  turn(camera, heading) {
    this.preview(camera, {heading: (heading * Math.PI) / 180});
    this.edit({command: 'turn', camera, heading});
  }

  /** A camera more, next to this one, on the side where there is room. */
  add(camera) {
    const {x, y} = this.pose(camera);
    const {minX, maxX} = this.runs[0].setup.field;
    const apart = APART * this.nudge();
    this.send({
      command: 'add',
      like: camera,
      ...this.inField(x + (x + apart > maxX && x - apart >= minX ? -apart : apart), y),
    });
  }

  /** A camera more, or this one elsewhere, where it can see the most that others cannot. */
  async suggest(camera) {
    say(this.said, 'looking for a place');
    const before =
      camera < 0 ? 'a camera more' : `camera ${this.runs[0].setup.cameras[camera].name}: moved`;
    say(this.said, (await this.send({command: 'suggest', camera})) ? before : '');
  }

  /** Has a camera stay in a view, or leaves it to the policy again with -1. */
  hold(camera, view) {
    const {name, pose} = this.runs[0].setup.cameras[camera];
    say(
      this.said,
      view < 0
        ? `camera ${name}: its views are left to the policy`
        : `camera ${name}: held at ${viewName(pose, view)}`,
    );
    this.send({command: 'hold', camera, view});
  }

  async wall(...ends) {
    const [x1, y1, x2, y2] = ends.map(tidy);
    if (await this.send({command: 'wall', x1, y1, x2, y2}))
      say(this.said, `wall from (${x1}, ${y1}) to (${x2}, ${y2}) added`);
  }

  async remove(obstacle) {
    const place = located(this.runs[0].setup.obstacles[obstacle]);
    if (await this.send({command: 'remove', obstacle})) say(this.said, `${place}: removed`);
  }

  async removeNamed(kind, {name}, command) {
    if (await this.send(command)) say(this.said, `${kind} ${name}: removed`);
  }

  /** Ctrl+Z takes the last change back, with shift, or Ctrl+Y, it is made again. */
  keyedBack(event) {
    const key = event.key.toLowerCase();
    if (
      !(event.ctrlKey || event.metaKey) ||
      !'zy'.includes(key) ||
      event.target.tagName === 'INPUT'
    )
      return;
    event.preventDefault();
    this.send({command: key === 'y' || event.shiftKey ? 'redo' : 'undo'});
  }

  /** Shows the camera so at once, and says it. */
  preview(camera, change) {
    this.playhead.show(this.playhead.count - 1);
    this.runs.forEach(run => run.preview(camera, change));
    this.players.forEach(player => player.show(this.playhead.frame));
    const {x, y, heading} = this.pose(camera);
    say(
      this.said,
      `camera ${this.runs[0].setup.cameras[camera].name}: x ${decimals(x, 3)} m, y ${decimals(y, 3)} m, heading ${decimals(degrees(heading), 1)} degrees`,
    );
  }

  /** The simulations get the latest of each kind for each camera, one command at a time. */
  async edit(command) {
    this.pending.set(`${command.command} ${command.camera}`, command);
    if (this.editing) return;
    this.editing = true;
    for (const [key, latest] of this.pending) {
      this.pending.delete(key);
      if (!(await this.send(latest))) this.runs.forEach(run => run.forgetPreview(latest.camera));
    }
    this.editing = false;
  }
}

/** The mean score of the last steps that are known. */
function meanScore(run) {
  const last = run.score.slice(-RECENT);
  return last.length
    ? `${scoreText(last.reduce((sum, score) => sum + score, 0) / last.length, run.objective)}, the mean of the last ${last.length} steps`
    : '';
}
