// The form that removes a target, chosen by name or by a click in the field.
import {el} from './dom.js';

export class TargetForm {
  /**
   * @param edit has `removeTarget(target)`, which is called with an index
   */
  constructor({targets}, edit) {
    this.list = el(
      'select',
      {name: 'target', 'aria-label': 'target to remove'},
      ...targets.map(({name}, i) => el('option', {value: i}, name)),
    );
    this.element = targets.length
      ? el(
          'details',
          {class: 'pose drawing'},
          el('summary', {}, 'targets'),
          el(
            'p',
            {},
            this.list,
            el(
              'button',
              {
                type: 'button',
                class: 'remove-target',
                onclick: () => edit.removeTarget(Number(this.list.value)),
              },
              'remove',
            ),
          ),
        )
      : null;
  }

  choose(target) {
    if (!this.element) return;
    this.list.value = String(target);
    this.element.open = true;
  }
}
