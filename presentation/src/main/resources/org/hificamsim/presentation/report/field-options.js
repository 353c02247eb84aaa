// The options below a field: heat map, paths, density zones, opacity of the floor plan, beliefs.
import {el} from './dom.js';

const BELIEFS =
  'what cameras believe: where seen targets are (circles), where others are expected (shaded), ' +
  'and which cameras received messages of the selected one (arrows)';

/**
 * Returns the options of a field, {element, beliefs}; `beliefs` is hidden until a run has some.
 * @param field the FieldView, whose `set(name, value)` is called after each choice
 */
export function fieldOptions(field) {
  const checkbox = (property, name, label, attributes = {}) =>
    el(
      'label',
      attributes,
      el('input', {
        type: 'checkbox',
        name,
        onchange: event => field.set(property, event.target.checked),
      }),
      ` ${label}`,
    );
  const hasDensities = field.run.setup.cameras.some(({pose}) =>
    pose.lenses?.some(({density}) => density),
  );
  const densityZones = 'pixel density of the selected camera (IEC 62676-4:2025, px/m)';
  const simulating = {class: 'simulating'};
  const beliefs = checkbox('beliefs', 'beliefs', BELIEFS, simulating);
  beliefs.hidden = true;
  const element = el(
    'div',
    {class: 'field-options', role: 'group', 'aria-label': 'what the field shows'},
    ...(field.heat
      ? [el('label', simulating, 'heat map ', field.heat.select), field.heat.key]
      : []),
    checkbox('trails', 'trails', 'last steps', simulating),
    checkbox('tracks', 'tracks', 'whole paths', simulating),
    hasDensities ? checkbox('densityZones', 'density-zones', densityZones) : null,
    field.floor.length ? el('label', {}, 'floorplan ', floorSlider(field)) : null,
    beliefs,
  );
  return {element, beliefs};
}

const floorSlider = field =>
  el('input', {
    type: 'range',
    name: 'floor',
    data: {keys: 'own'},
    min: 0,
    max: 100,
    step: 5,
    value: 100 * field.opacity,
    oninput: event => field.set('opacity', event.target.value / 100),
  });
