// The numbers of a step: its row of steps.csv, and its score.
import {el, setText} from './dom.js';
import {scoreNumber} from './names.js';
import {decimals} from './numbers.js';

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
    this.score = el('dd', {data: {name: 'score'}});
    const score =
      run.objective &&
      !run.objective.kMin &&
      el(
        'div',
        {class: 'score', title: run.objective.text},
        this.score,
        el('dt', {}, run.objective.title),
      );
    this.element = el(
      'dl',
      {class: 'readout'},
      score || null,
      ...NUMBERS.map(([name, label]) =>
        el('div', {class: name}, this.values[name], el('dt', {}, label)),
      ),
    );
  }

  show(frame) {
    if (!this.run.count) return;
    const row = this.run.row(frame);
    if (this.run.scored)
      setText(this.score, scoreNumber(this.run.score[frame], this.run.objective));
    for (const [name] of NUMBERS) setText(this.values[name], decimals(row[name], 3));
  }
}
