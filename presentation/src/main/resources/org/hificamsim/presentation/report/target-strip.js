// Shows which camera had each target over time, with one bar for each target.
import {el, style} from './dom.js';
import {Strip} from './strip.js';

const ABSENT = -2;
const MIN_TEXT_ROW = 10; // CSS pixels
const SHADES = [0.2, 0.36]; // opacities of cameras with even and odd numbers

export class TargetStrip extends Strip {
  constructor(playhead, handlers) {
    const label = 'which camera had each target over time';
    super(playhead, {title: 'which camera had each target', label, name: 'targets'}, key());
    this.box.addEventListener('click', event => {
      const {left} = this.box.getBoundingClientRect();
      handlers.select(this.run.holders[this.rowAt(event)][this.frameAt(event.clientX - left)]);
    });
  }

  namesOf({targets}) {
    return targets.map(({name}) => el('span', {title: `target ${name}`}, name));
  }

  /** Shows the targets of a camera in full colour. */
  select(camera) {
    this.selected = camera;
    this.surface.draw();
  }

  describe(target, frame) {
    const {setup, step, holders, present, coverage} = this.run;
    const holder = holders[target][frame];
    const others = coverage[target][frame] - 1;
    const text = !present[target][frame]
      ? 'not there'
      : holder < 0
        ? 'no camera covers it'
        : `${setup.cameras[holder].name} has it` + (others > 0 ? `, and ${others} more` : '');
    return `target ${setup.targets[target].name}, step ${step[frame]}: ${text}`;
  }

  paint(context, width, height) {
    const {step, count, holders} = this.run;
    const first = step[0];
    const steps = step[count - 1] - first + 1;
    const x = frame => (frame < count ? ((step[frame] - first) / steps) * width : width);
    const row = height / holders.length;
    context.font = `${Math.min(0.75 * row, 11)}px sans-serif`;
    context.textBaseline = 'middle';
    holders.forEach((list, target) => {
      for (let from = 0, to; from < count; from = to) {
        const holder = this.holderOf(target, from);
        for (to = from + 1; to < count && this.holderOf(target, to) === holder; ) to++;
        this.bar(context, holder, {x: x(from), y: target * row, width: x(to) - x(from), row});
      }
    });
  }

  holderOf(target, frame) {
    return this.run.present[target][frame] ? this.run.holders[target][frame] : ABSENT;
  }

  bar(context, holder, {x, y, width, row}) {
    if (holder === ABSENT) return;
    if (holder < 0) {
      context.fillStyle = MEANING.unseen;
      context.fillRect(x, y + 0.4 * row, width, 0.2 * row);
      return;
    }
    const selected = holder === this.selected;
    context.fillStyle = style('--accent');
    context.globalAlpha = selected ? 1 : SHADES[holder % 2];
    context.fillRect(x, y + 0.1 * row, Math.max(width - 1, 0.5), 0.8 * row);
    context.globalAlpha = 1;
    const {name} = this.run.setup.cameras[holder];
    if (row < MIN_TEXT_ROW || context.measureText(name).width > width - 6) return;
    context.fillStyle = style(selected ? '--paper' : '--ink');
    context.fillText(name, x + 3, y + 0.5 * row);
  }
}

function key() {
  const swatch = colour => {
    const element = el('i', {class: 'swatch'});
    element.style.background = colour;
    return element;
  };
  return el(
    'span',
    {class: 'key'},
    swatch('var(--accent)'),
    'the selected camera\u2003',
    swatch(MEANING.unseen),
    'none',
  );
}
