// Words for names that files contain. Pages show the words, and tooltips the names themselves.
// SpokenNames (Java) writes the constant SPOKEN with the words for the names in a page's data.
import {el} from './dom.js';
import {decimals, decimalsOf, percent, significant} from './numbers.js';

/** Adds the user's own words for policies and detections, an object by name. */
export const useLabels = (labels = {}) =>
  Object.entries(labels).forEach(([name, text]) => SPOKEN.set(name, text));

/** The name of a column or setting in words. */
export const words = name => name.replaceAll('_', ' ');

/** A policy, detection or objective, such as hifi:orb-lin@chance or covered:k=2, in words. */
export const spelled = spec => SPOKEN.get(spec) ?? spec;

/** A number as text, a share as a percentage, with as many digits as its interval justifies. */
export function withUnit(value, unit = '', {low, high} = {}) {
  if (!Number.isFinite(value)) return '–';
  return isShare(unit)
    ? `${decimals(100 * value, decimalsOf(100 * low, 100 * high, 2))} %`
    : decimals(value, decimalsOf(low, high, 4));
}

export const isShare = unit => /^share\b/.test(unit);

/** The unit as it is shown after a number: what is left of a share's after the percent sign. */
export const unitAfterPercent = (unit = '') =>
  isShare(unit) ? unit.replace(/^share ?/, '') : unit;

/** The value of a setting, which may be a list or an object, in words. */
export function settingText(value) {
  if (Array.isArray(value))
    return (
      value
        .map(settingText)
        .join(value.some(part => part !== null && typeof part === 'object') ? '; ' : ' ') || 'none'
    );
  if (value !== null && typeof value === 'object')
    return Object.entries(value)
      .map(([name, part]) => `${words(name)} ${settingText(part)}`)
      .join(', ');
  const isFraction = typeof value === 'number' && !Number.isInteger(value);
  return isFraction ? significant(value, 6) : String(value ?? '–');
}

const IN_METRES = /^(zooms|mount_height|focal_lengths)$/;

/** The name of a setting in words, with its unit. */
export const settingName = name => words(name) + (IN_METRES.test(name) ? ' (m)' : '');

/** The names of settings, without those that only say where another setting is from. */
export const settingNames = settings =>
  Object.keys(settings).filter(name => !name.endsWith('_from'));

/** The value of a setting in words, followed by its source if the settings have that. */
export function settingOf(settings, name) {
  const value = settings[name];
  const source = settings[`${name}_from`];
  const text = typeof value === 'string' ? spelled(value) : settingText(value);
  return source ? `${text} (${source})` : text;
}

/** A text with the raw name in its tooltip, if that differs. */
export const tipped = (text, raw) => el('span', {title: raw === text ? null : raw}, text);

/** A score per step as text: a percentage if the objective is a share. */
export const scoreNumber = (score, {share}) => (share ? percent(score) : decimals(score, 2));

/** A score per step after the objective's title. */
export const scoreText = (score, objective) =>
  `${objective.title}: ${scoreNumber(score, objective)}`;
