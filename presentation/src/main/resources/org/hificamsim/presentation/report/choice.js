// The form that chooses the detection model, threshold and policy of a simulation.
import {el, setText} from './dom.js';
import {spelled} from './names.js';
import {decimals} from './numbers.js';
import {isStill} from './views.js';

let formCount = 0;

export class ChoiceForm {
  /**
   * @param data the data of the page, written by LivePage
   * @param onChoose is called with `{detection, threshold, policy}`; a null threshold means that of
   *   the model
   */
  constructor(data, onChoose) {
    const id = `choice-${formCount++}`;
    this.policies = data.policies;
    this.detection = el(
      'select',
      {id: `${id}-detection`, name: 'detection'},
      ...data.detections.map(name => el('option', {value: name, title: name}, spelled(name))),
    );
    this.policy = el(
      'select',
      {id: `${id}-policy`, name: 'policy'},
      ...data.policies.map(({name, summary}) => el('option', {value: name, title: summary}, name)),
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
    this.policyLabels = [labelled('policy', this.policy), labelled('options', this.options)];
    this.policy.addEventListener('change', () => (this.options.value = ''));
    this.detection.addEventListener('change', () => (this.threshold.value = ''));
    this.element = el(
      'form',
      {
        class: 'choice card',
        onchange: () => onChoose(this.choice()),
        onsubmit: event => event.preventDefault(),
      },
      labelled('detection', this.detection),
      labelled('threshold', this.threshold),
      ...this.policyLabels,
      this.mean,
    );
  }

  /** Shows a setup, except in the input that the user is typing in. */
  show(setup) {
    const [name, options] = nameAndOptions(this.policies, setup.policy);
    const show = (input, value) =>
      (input === document.activeElement && input.tagName === 'INPUT') || (input.value = value);
    const [model, rule] = setup.detection.split(/@(?=threshold|chance|probability)/);
    const listed = [...this.detection.options].some(({value}) => value === setup.detection);
    show(this.detection, listed ? setup.detection : model);
    this.threshold.disabled = rule !== undefined; // a rule brings its own threshold
    show(this.threshold, rule === undefined ? decimals(setup.threshold, 6) : '');
    this.policyLabels.forEach(label => (label.hidden = isStill(setup)));
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

  /** Shows the mean score of the last steps, as a text. */
  showMean(text) {
    setText(this.mean, text);
  }
}

const labelled = (text, input) => el('label', {for: input.id}, text, ' ', input);

/** Splits the text of a policy into its name and its options. */
function nameAndOptions(policies, text) {
  const candidates = policies
    .map(policy => policy.name)
    .filter(name => text === name || text.startsWith(`${name}:`));
  const name = candidates.sort((a, b) => b.length - a.length)[0] ?? text;
  return [name, text.slice(name.length + 1)];
}
