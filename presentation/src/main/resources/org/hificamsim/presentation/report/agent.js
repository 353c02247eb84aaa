// The panel of the selected camera: what it does and knows, with a bar for each zoom level or view.
import {el, setText} from './dom.js';
import {PoseForm} from './pose-form.js';
import {detections} from './tooltip.js';
import {ViewTable} from './view-table.js';
import {viewCount, viewName, viewOf} from './views.js';
import {sentMessages} from './belief.js';
import {decimals, metres} from './numbers.js';

const MEANING = {
  Q: 'Q of the state the camera is in. ',
  gain:
    'Gain: what a view would add over the next steps to the views that the others chose, ' +
    'given where the camera believes targets to be. ',
  'mean reward': 'Reward: targets detected at that level. ',
};

export class AgentPanel {
  /**
   * @param edit the functions that {@link PoseForm} needs, `hold(camera, view)` and
   *   `isHeld(camera)`; undefined if cameras cannot be changed
   */
  constructor(run, edit) {
    this.run = run;
    this.camera = 0;
    this.form = edit && new PoseForm(edit);
    this.hasCounts = Boolean(run.estimated) && !['Q', 'gain'].includes(run.estimated);
    this.title = el('h2', {}, '');
    this.facts = el('p', {class: 'facts'});
    this.edit = edit;
    this.head = el('tr');
    this.views = el('div');
    this.body = el('tbody');
    this.note = el('p', {class: 'note'});
    this.element = el(
      'section',
      {class: 'agent', 'aria-label': 'the chosen camera'},
      this.title,
      this.facts,
      this.form?.element,
      el('table', {}, el('thead', {}, this.head), this.body),
      this.views,
      this.note,
    );
    if (run.setup.cameras.length) this.select(0);
  }

  select(camera) {
    this.camera = camera;
    setText(this.title, this.run.setup.cameras[camera].name);
    const {pose} = this.run.setup.cameras[camera];
    const oneDirection = !pose.pans; // otherwise the estimates are in the table of views
    const ranked = oneDirection && viewCount(pose) > 1;
    const estimated = ranked && this.run.estimated;
    const hasCounts = ranked && this.hasCounts;
    const rangeHeads = [pose.lenses ? 'angle' : 'radius', 'detects at'].map(text =>
      el('th', {scope: 'col'}, text),
    );
    this.head.replaceChildren(
      el('th', {scope: 'col'}, 'level'),
      ...rangeHeads,
      ...(estimated ? [el('th', {scope: 'col', class: 'wide'}, estimated)] : []),
      ...(hasCounts ? [el('th', {scope: 'col'}, 'times used')] : []),
    );
    const canHold = oneDirection && this.edit;
    this.rows = pose.levels.map((level, i) =>
      levelRow(i, estimated, hasCounts, canHold && (() => this.edit.hold(this.camera, i))),
    );
    this.showViews(pose);
    this.body.replaceChildren(...this.rows.map(row => row.element).reverse());
    this.pose = null;
    this.show(this.frame || 0);
  }

  /**
   * Shows the table of a camera that can turn, and the button that leaves its views to the policy.
   */
  showViews(pose) {
    const {edit} = this;
    const hold = edit && (view => edit.hold(this.camera, view));
    this.table = pose.pans ? new ViewTable(pose, hold) : null;
    this.releaseButton = edit
      ? el(
          'button',
          {type: 'button', class: 'free', hidden: true, onclick: () => hold(-1)},
          'leave its views to the policy',
        )
      : null;
    this.views.replaceChildren(
      ...[
        this.table && el('h3', {}, this.run.estimated ? `views: ${this.run.estimated}` : 'views'),
        this.releaseButton,
        this.table?.element,
      ].filter(Boolean),
    );
  }

  show(frame) {
    this.frame = frame;
    const {run, camera} = this;
    if (!run.count || !this.rows) return;
    const pose = run.pose(camera, frame);
    const view = run.level[camera][frame];
    const blind = run.seen(camera, frame) < 0;
    const online = run.online[camera][frame];
    const turning = blind && 'turning to its view, sees nothing';
    const facts = online ? [detections(run, frame, camera), turning] : ['not online'];
    const place = `x ${metres(pose.x)}, y ${metres(pose.y)}`;
    setText(this.facts, [place, ...facts].filter(Boolean).join('; '));
    this.form?.show(camera, pose);
    if (pose !== this.pose) this.showLevels(pose);
    this.rows.forEach((row, i) =>
      row.element.classList.toggle('now', Boolean(online) && i === view % pose.levels.length),
    );
    if (this.releaseButton) this.releaseButton.hidden = !this.edit.isHeld(camera);
    if (this.table) this.showTable(frame, online ? view : -1, blind);
    else if (run.estimated) this.showEstimates(frame);
    setText(this.note, this.remark());
  }

  showTable(frame, view, blind) {
    const {run, camera} = this;
    const valuesInFrame = lists => (run.estimated ? lists[camera].map(list => list[frame]) : null);
    const counts = this.hasCounts ? valuesInFrame(run.counts) : null;
    this.table.show(view, blind, valuesInFrame(run.estimates), counts);
  }

  showLevels(pose) {
    this.pose = pose;
    pose.levels.forEach((level, i) => {
      const {viewingAngle} = viewOf(pose, i);
      setText(
        this.rows[i].radius,
        pose.lenses
          ? `${decimals((viewingAngle * 180) / Math.PI, 1)}°`
          : `${decimals(level.radius, 3)} m`,
      );
      setText(
        this.rows[i].range,
        level.detected.map(({from, to}) => `${decimals(from)}–${decimals(to)} m`).join(', ') ||
          'nowhere',
      );
    });
  }

  /**
   * Shows a bar for each level. The largest absolute value has the longest bar; negative values
   * are hatched.
   */
  showEstimates(frame) {
    const values = this.run.estimates[this.camera].map(list => list[frame]);
    const largest = Math.max(1e-12, ...values.filter(Number.isFinite).map(Math.abs));
    values.forEach((value, i) => {
      const row = this.rows[i];
      const known = Number.isFinite(value) && value !== null;
      const count = this.run.counts[this.camera][i][frame];
      row.bar.style.transform = `scaleX(${known ? Math.abs(value) / largest : 0})`;
      row.bar.classList.toggle('negative', known && value < 0);
      setText(row.value, known ? decimals(value, 4) : '–');
      setText(row.count, Number.isFinite(count) && count !== null ? String(count) : '–');
    });
  }

  remark() {
    const {policy, targetSize, onAxis} = this.run.setup;
    const target = `a target of ${decimals(targetSize, 3)} m${onAxis ? ' straight ahead' : ''}`;
    const range = `"detects at" is for ${target}.${this.lens()}`;
    if (viewCount(this.run.setup.cameras[this.camera].pose) === 1) return range;
    if (!this.run.estimated) return `${policy} keeps no estimates of its levels. ${range}`;
    return (MEANING[this.run.estimated] || '') + this.bestViews() + this.messages() + range;
  }

  /** Names the three views with the largest gain, the best first; empty without gains. */
  bestViews() {
    const {run, camera, frame} = this;
    if (run.estimated !== 'gain') return '';
    const gains = run.estimates[camera]
      .map((list, view) => [list[frame], view])
      .filter(([gain]) => Number.isFinite(gain));
    const best = gains
      .sort(([a], [b]) => b - a)
      .slice(0, 3)
      .map(([gain, view]) => `${viewName(run.pose(camera, frame), view)}: ${decimals(gain, 3)}`);
    return best.length ? `Largest: ${best.join('; ')}. ` : '';
  }

  /** Says what the camera sent in this step and which cameras received it. */
  messages() {
    const {run, camera, frame} = this;
    const sent = run.online[camera][frame] && sentMessages(run, frame, camera);
    if (!sent) return '';
    const others = run.online.filter((list, i) => list[frame] && i !== camera).length;
    const names = sent.receivers.map(i => run.setup.cameras[i].name);
    const receivers = names.length === others ? 'all others' : names.join(', ') || 'nobody';
    const seen = sent.messages ? 'what it saw in one message' : 'nothing of what it saw';
    const chosen = sent.messages > 1 ? `, and what it chose in ${sent.messages - 1} more` : '';
    return `In this step it sent ${seen}${chosen}; ${receivers} received it. `;
  }

  /** Says the focal length of each level and the mount height, if the settings have them. */
  lens() {
    const {focal_lengths: lengths = [], mount_height: height} = this.run.lens ?? {};
    const levels = this.run.setup.cameras[this.camera].pose.levels.length;
    const millimetres = lengths.map(length => decimals(1000 * length, 1)).join(', ');
    const focal =
      lengths.length === levels ? ` Focal length by level, from 0: ${millimetres} mm.` : '';
    return focal + (height ? ` Mounted ${decimals(height, 3)} m over the targets.` : '');
  }
}

function levelRow(level, estimated, hasCounts, hold) {
  const row = {
    radius: el('td'),
    range: el('td'),
    bar: el('i', {class: 'bar'}),
    value: el('span'),
    count: el('td'),
  };
  row.element = el(
    'tr',
    {data: {level}},
    el(
      'th',
      {scope: 'row'},
      hold
        ? el(
            'button',
            {
              type: 'button',
              class: 'hold',
              'aria-label': `hold level ${level}`,
              title: `hold level ${level}`,
              onclick: hold,
            },
            String(level),
          )
        : String(level),
    ),
    row.radius,
    row.range,
    estimated ? el('td', {class: 'wide'}, row.bar, row.value) : null,
    hasCounts ? row.count : null,
  );
  row.value.dataset.name = 'estimate';
  return row;
}
