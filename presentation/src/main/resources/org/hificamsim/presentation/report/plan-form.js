// The form that plans the cameras of a site, with the progress and result of the plan.
import {el, setText} from './dom.js';

const GOALS = {
  CAMERAS: {text: 'meet most with this many cameras', amount: 4, step: 1},
  BUDGET: {text: 'meet most within this budget', amount: 3000, step: 'any'},
  COVER: {text: 'meet everything at the lowest price'},
};

export class PlanForm {
  /**
   * @param send sends a command to the simulation
   */
  constructor(send) {
    this.goal = el(
      'select',
      {name: 'goal', 'aria-label': 'goal of the plan', onchange: () => this.choose()},
      ...Object.entries(GOALS).map(([value, {text}]) => el('option', {value}, text)),
    );
    this.amount = el('input', {type: 'number', name: 'amount', min: 1, 'aria-label': 'how many'});
    this.height = el('input', {
      type: 'number',
      name: 'mountHeight',
      step: 'any',
      onchange: () => send({command: 'mountheight', metres: Number(this.height.value)}),
    });
    this.heightLabel = el('label', {}, 'cameras hang at, m ', this.height);
    this.ceiling = el('input', {type: 'checkbox', name: 'ceiling'});
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
    this.event = el('p', {class: 'event', role: 'status'});
    this.facts = el('ul', {class: 'note'});
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
        this.heightLabel,
        el('label', {}, this.ceiling, ' also on the ceiling'),
        el('label', {}, this.keep, ' keep present cameras'),
        this.start,
        this.stop,
      ),
      this.bar,
      this.event,
      this.facts,
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
      ceiling: this.ceiling.checked,
    };
  }

  /**
   * Shows the state of the plan, the Java record PlanTask.Message, if there is a plan.
   *
   * @param mountHeight the height of all cameras in metres; undefined if the site has none
   */
  show({running = false, event = '', facts = [], share = 0, fault = ''} = {}, mountHeight) {
    const hasEnded = this.start.disabled && !running;
    this.start.disabled = running;
    this.stop.hidden = this.bar.hidden = !running;
    this.bar.value = share;
    setText(this.event, fault ? `no plan: ${fault}` : event);
    this.facts.replaceChildren(...facts.map(fact => el('li', {}, fact)));
    this.heightLabel.hidden = mountHeight === undefined;
    if (document.activeElement !== this.height) this.height.value = mountHeight ?? '';
    if (hasEnded) this.event.scrollIntoView({block: 'nearest'});
  }
}
