// The form that plans all cameras of a site, with its progress and what the plan meets.
import {el, setText} from './dom.js';

const GOALS = {
  CAMERAS: {text: 'the most by this many cameras', amount: 4, step: 1},
  BUDGET: {text: 'the most for this budget', amount: 3000, step: 'any'},
  COVER: {text: 'everything, for the least'},
};

export class PlanForm {
  /**
   * @param send sends a command
   */
  constructor(send) {
    this.goal = el(
      'select',
      {name: 'goal', 'aria-label': 'goal of the plan', onchange: () => this.choose()},
      ...Object.entries(GOALS).map(([value, {text}]) => el('option', {value}, text)),
    );
    this.amount = el('input', {type: 'number', name: 'amount', min: 1, 'aria-label': 'how many'});
    this.keep = el('input', {type: 'checkbox', name: 'keep'});
    this.start = el('button', {class: 'plan'}, 'plan the cameras');
    this.stop = el(
      'button',
      {type: 'button', class: 'stop', hidden: true, onclick: () => send({command: 'stopplan'})},
      'stop',
    );
    this.bar = el('progress', {
      max: 1,
      value: 0,
      hidden: true,
      'aria-label': 'progress of the plan',
    });
    this.event = el('p', {class: 'note', role: 'status'});
    this.element = el(
      'details',
      {class: 'pose drawing planning'},
      el('summary', {}, 'plan'),
      el(
        'form',
        {
          onsubmit: event => {
            event.preventDefault();
            send(this.command());
          },
        },
        this.goal,
        this.amount,
        el('label', {}, this.keep, ' keep those that are there'),
        this.start,
        this.stop,
      ),
      this.bar,
      this.event,
    );
    this.choose();
  }

  choose() {
    const {amount, step} = GOALS[this.goal.value];
    this.amount.hidden = amount === undefined;
    Object.assign(this.amount, {value: amount ?? 1, step: step ?? 1});
  }

  command() {
    return {
      command: 'plan',
      goal: this.goal.value,
      amount: Number(this.amount.value),
      keep: this.keep.checked,
    };
  }

  /** Shows the state of the plan: the record Message of PlanTask, or nothing. */
  show({running = false, event = '', share = 0, fault = ''} = {}) {
    this.start.disabled = running;
    this.stop.hidden = this.bar.hidden = !running;
    this.bar.value = share;
    setText(this.event, fault ? `no plan: ${fault}` : event);
  }
}
