// The numbers of the step that is shown: a row of steps.csv.
import { el, say } from './dom.js';
import { decimals } from './numbers.js';

const NUMBERS = [
  ['k_min', 'least cameras on a target (k_min)'],
  ['mean_k', 'cameras per target, mean'],
  ['targets', 'targets'],
  ['covered_0', 'covered by none'],
  ['covered_1', 'covered by one'],
  ['covered_k', 'covered by two or more'],
];

export class Readout {
  constructor(run) {
    this.run = run;
    this.values = Object.fromEntries(NUMBERS.map(([name]) => [name, el('dd', {data: {name}})]));
    this.element = el('dl', {class: 'readout'},
      ...NUMBERS.map(([name, label]) => el('div', {class: name}, this.values[name], el('dt', {}, label))));
  }

  show(frame) {
    if (!this.run.count) return;
    const row = this.run.row(frame);
    for (const [name] of NUMBERS) say(this.values[name], decimals(row[name], 3));
  }
}
