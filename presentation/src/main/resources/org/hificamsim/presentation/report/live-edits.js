// Changes that a user makes to cameras, walls, zones and targets of a live view by keys or forms.
import {setText} from './dom.js';
import {decimals} from './numbers.js';
import {degrees, rounded} from './pose-form.js';
import {describeWithPosition} from './site.js';
import {viewName} from './views.js';

const NUDGE = 0.01; // a share of the field's longer side
const TURN = 3; // degrees
const NUDGES_APART = 5; // the distance of an added camera from the one that it copies

/**
 * The keys that move the selected camera, by [right, up] in nudges, and those that turn it, in
 * degrees clockwise.
 */
const MOVES = {KeyW: [0, 1], KeyA: [-1, 0], KeyS: [0, -1], KeyD: [1, 0]};
const TURNS = {KeyQ: -TURN, KeyE: TURN};

export class LiveEdits {
  /**
   * @param view the LiveView
   * @param status the element that says what was changed
   */
  constructor(view, status) {
    this.view = view;
    this.status = status;
    this.pending = new Map(); // the latest command of each kind for each camera
    this.sending = false;
  }

  get run() {
    return this.view.runs[0];
  }

  get setup() {
    return this.run.setup;
  }

  say(text) {
    setText(this.status, text);
  }

  /** The last known pose of a camera, with the changes that are not yet confirmed. */
  pose(camera) {
    return this.run.poses[camera].at(-1).pose;
  }

  /**
   * Returns the function by which a key moves or turns the selected camera; null if it has none.
   */
  actionOf({code, shiftKey}, camera) {
    if (!(camera in (this.run?.poses ?? []))) return null;
    const pose = this.pose(camera);
    const factor = shiftKey ? 10 : 1;
    if (code in TURNS) return () => this.turn(camera, degrees(pose.heading) + factor * TURNS[code]);
    if (!(code in MOVES)) return null;
    const [right, up] = MOVES[code].map(nudges => factor * nudges * this.nudge());
    return () => this.move(camera, pose.x + right, pose.y + up);
  }

  /** Ctrl+Z undoes the last change; with shift, or as Ctrl+Y, it redoes it. */
  onUndoKey(event) {
    const key = event.key.toLowerCase();
    const modified = event.ctrlKey || event.metaKey;
    if (!modified || !'zy'.includes(key) || event.target.tagName === 'INPUT') return;
    event.preventDefault();
    this.view.send({command: key === 'y' || event.shiftKey ? 'redo' : 'undo'});
  }

  /** The length of a nudge in metres. */
  nudge() {
    const {minX, maxX, minY, maxY} = this.setup.field;
    return NUDGE * Math.max(maxX - minX, maxY - minY);
  }

  /** Returns the nearest position within the field, {x, y} in metres, to the millimetre. */
  inField(x, y) {
    const {minX, maxX, minY, maxY} = this.setup.field;
    return {
      x: Math.min(Math.max(rounded(x), minX), maxX),
      y: Math.min(Math.max(rounded(y), minY), maxY),
    };
  }

  move(camera, x, y) {
    const position = this.inField(x, y);
    this.preview(camera, position);
    this.enqueue({command: 'drag', camera, ...position});
  }

  turn(camera, heading) {
    this.preview(camera, {heading: (heading * Math.PI) / 180});
    this.enqueue({command: 'turn', camera, heading});
  }

  /** Copies a camera next to it, to the right unless only the left side is in the field. */
  add(camera) {
    const {x, y} = this.pose(camera);
    const {minX, maxX} = this.setup.field;
    const distance = NUDGES_APART * this.nudge();
    const left = x + distance > maxX && x - distance >= minX;
    const position = this.inField(left ? x - distance : x + distance, y);
    this.view.send({command: 'add', like: camera, ...position});
  }

  /**
   * Moves a camera to where it sees most of what the others do not see; -1 adds a camera there.
   */
  async suggest(camera) {
    this.say('looking for a place');
    const done = camera < 0 ? 'camera added' : `camera ${this.setup.cameras[camera].name}: moved`;
    this.say((await this.view.send({command: 'suggest', camera})) ? done : '');
  }

  /** Keeps a camera in a view; -1 leaves its views to the policy again. */
  hold(camera, view) {
    const {name, pose} = this.setup.cameras[camera];
    this.say(
      view < 0
        ? `camera ${name}: its views are left to the policy`
        : `camera ${name}: held at ${viewName(pose, view)}`,
    );
    this.view.send({command: 'hold', camera, view});
  }

  /** Whether a camera is kept in a view. */
  isHeld(camera) {
    return this.view.held.includes(camera);
  }

  /** Draws with a tool of drawing-tools.js between two ends: x1, y1, x2 and y2 in metres. */
  async draw(tool, ends) {
    const [x1, y1, x2, y2] = ends;
    if (await this.view.send(tool.command(ends)))
      this.say(`${tool.name} from (${x1}, ${y1}) to (${x2}, ${y2}) added`);
  }

  removeZone(zone, name) {
    this.remove(`zone ${name}`, {command: 'removezone', zone});
  }

  removeObstacle(obstacle) {
    this.remove(describeWithPosition(this.setup.obstacles[obstacle]), {
      command: 'remove',
      obstacle,
    });
  }

  removeCamera(camera) {
    const {name} = this.setup.cameras[camera];
    this.remove(`camera ${name}`, {command: 'removecamera', camera});
  }

  removeTarget(target) {
    const {name} = this.setup.targets[target];
    this.remove(`target ${name}`, {command: 'removetarget', target});
  }

  async remove(description, command) {
    if (await this.view.send(command)) this.say(`${description}: removed`);
  }

  /** Shows a camera in its new pose before the simulation confirms it. */
  preview(camera, change) {
    this.view.previewPose(camera, change);
    const {x, y, heading} = this.pose(camera);
    this.say(
      `camera ${this.setup.cameras[camera].name}: x ${decimals(x, 3)} m, ` +
        `y ${decimals(y, 3)} m, heading ${decimals(degrees(heading), 1)} degrees`,
    );
  }

  /**
   * Sends commands one at a time. While one is under way, only the latest of each kind for each
   * camera is kept.
   */
  async enqueue(command) {
    this.pending.set(`${command.command} ${command.camera}`, command);
    if (this.sending) return;
    this.sending = true;
    for (const [key, latest] of this.pending) {
      this.pending.delete(key);
      if (!(await this.view.send(latest)))
        this.view.runs.forEach(run => run.forgetPreview(latest.camera));
    }
    this.sending = false;
  }
}
