// What a simulation runs under: detection model, threshold and policy, to be chosen while it runs.
import {el, say} from './dom.js';
import {spelled} from './names.js';
import {decimals} from './numbers.js';

let forms = 0;

export class ChoiceForm {
  /**
   * @param data what LivePage wrote
   * @param choose called with `{detection, threshold, policy}`, the threshold null for the model's own
   */
  constructor(data, choose) {
    const id = `choice-${forms++}`;
    this.policies = data.policies;
    this.detection = el(
      'select',
      {id: `${id}-detection`, name: 'detection'},
      ...data.detections.map(one => el('option', {value: one, title: one}, spelled(one))),
    );
    this.policy = el(
      'select',
      {id: `${id}-policy`, name: 'policy'},
      ...data.policies.map(one => el('option', {value: one.name, title: one.summary}, one.name)),
    );
    this.options = el('input', {
      id: `${id}-options`,
      name: 'options',
      placeholder: 'key=value,...',
      spellcheck: 'false',
    });
    this.threshold = el('input', {
      id: `${id}-threshold`,
      name: 'threshold',
      type: 'number',
      min: 0,
      max: 1,
      step: 'any',
    });
    this.mean = el('output', {class: 'recent'});
    this.policy.addEventListener('change', () => (this.options.value = ''));
    this.detection.addEventListener('change', () => (this.threshold.value = ''));
    this.element = el(
      'form',
      {
        class: 'choice card',
        onchange: () => choose(this.choice()),
        onsubmit: event => event.preventDefault(),
      },
      labelled('detection', this.detection),
      labelled('threshold', this.threshold),
      labelled('policy', this.policy),
      labelled('options', this.options),
      this.mean,
    );
  }

  /** Shows what the simulation runs under, but for the field that somebody is filling in. */
  show(setup) {
    const [name, options] = parts(this.policies, setup.policy);
    const show = (input, value) =>
      (input === document.activeElement && input.tagName === 'INPUT') || (input.value = value);
    const [model, rule] = setup.detection.split(/@(?=threshold|chance|probability)/);
    const named = [...this.detection.options].some(one => one.value === setup.detection); // with its own rule
    show(this.detection, named ? setup.detection : model);
    this.threshold.disabled = rule !== undefined; // a rule of chance has its own
    show(this.threshold, rule === undefined ? decimals(setup.threshold, 6) : '');
    show(this.policy, name);
    show(this.options, options);
  }

  choice() {
    const options = this.options.value.trim();
    return {
      detection: this.detection.value,
      threshold: this.threshold.value === '' ? null : Number(this.threshold.value),
      policy: this.policy.value + (options ? `:${options}` : ''),
    };
  }

  recent(text) {
    say(this.mean, text);
  }
}

const labelled = (text, input) => el('label', {for: input.id}, text, ' ', input);

/** The name and the options of a policy. */
function parts(policies, text) {
  const known = policies
    .map(policy => policy.name)
    .filter(one => text === one || text.startsWith(`${one}:`));
  const name = known.sort((a, b) => b.length - a.length)[0] ?? text;
  return [name, text.slice(name.length + 1)];
}
