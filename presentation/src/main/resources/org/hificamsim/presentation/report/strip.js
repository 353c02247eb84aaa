// A chart over the steps of a run with a row for each camera or target, and the playhead.
import {scrub} from './chart.js';
import {el, setText, Surface} from './dom.js';

export class Strip {
  /**
   * @param texts `title` and `label` of the strip, and `name`: "cameras" or "targets"
   * @param key the element of the legend
   */
  constructor(playhead, {title, label, name}, key) {
    this.value = el('span', {class: 'value'});
    this.surface = new Surface({role: 'img', 'aria-label': label}, (context, width, height) => {
      if (!this.run?.count) return;
      this.paint(context, width, height);
      this.show(this.frame || 0);
    });
    this.line = el('div', {class: 'playhead'});
    this.rows = el('div', {class: 'rows', role: 'group', 'aria-label': name});
    this.box = el('div', {class: 'strip'}, this.surface.canvas, this.line);
    this.element = el(
      'figure',
      {class: `chart zooms ${name}`},
      el('figcaption', {}, title, key, this.value),
      el('div', {class: 'strip-scroll'}, el('div', {class: 'strip-box'}, this.rows, this.box)),
    );
    scrub(this.box, playhead, x => this.frameAt(x));
    this.box.addEventListener('pointermove', event => this.hover(event));
    this.box.addEventListener('pointerleave', () => setText(this.value, ''));
  }

  load(run) {
    if (this.run?.setup !== run.setup) this.writeNames(this.namesOf(run.setup));
    this.run = run;
    this.surface.draw();
  }

  writeNames(names) {
    this.rows.replaceChildren(...names);
    this.element.dataset.rows = names.length;
    this.element.style.setProperty('--rows', names.length);
  }

  frameAt(x) {
    const first = this.run.step[0];
    const last = this.run.step[this.run.count - 1];
    return this.run.frameAt(first + (x / this.surface.width) * (last - first));
  }

  rowAt(event) {
    const box = this.box.getBoundingClientRect();
    const count = this.rows.children.length;
    const row = Math.floor(((event.clientY - box.top) / box.height) * count);
    return Math.max(0, Math.min(row, count - 1));
  }

  hover(event) {
    if (!this.run.count) return;
    const frame = this.frameAt(event.clientX - this.box.getBoundingClientRect().left);
    setText(this.value, this.describe(this.rowAt(event), frame));
  }

  show(frame) {
    this.frame = frame;
    if (!this.run?.count || !this.surface.width) return;
    const first = this.run.step[0];
    const last = this.run.step[this.run.count - 1];
    const x =
      last > first ? ((this.run.step[frame] - first) / (last - first)) * this.surface.width : 0;
    this.line.style.transform = `translateX(${x}px)`;
  }
}
