// The words that people read for names in files; tooltips have the names themselves. SpokenNames
// writes SPOKEN, for the names in a page's data.
import {el} from './dom.js';
import {decimals, decimalsOf, percent, significant} from './numbers.js';

/** Replaces names by the user's own words for policies and detections. */
export const useLabels = (labels = {}) =>
  Object.entries(labels).forEach(([name, text]) => SPOKEN.set(name, text));

/** The name of a column or setting in words. */
export const words = name => name.replaceAll('_', ' ');

/** A policy, detection or objective, such as hifi:orb-lin@chance or covered:k=2, in words. */
export const spelled = spec => SPOKEN.get(spec) ?? spec;

/** A number with its unit: shares as percentages, with the digits that its interval gives it. */
export function withUnit(value, unit = '', {low, high} = {}) {
  if (!Number.isFinite(value)) return '–';
  return isShare(unit)
    ? `${decimals(100 * value, decimalsOf(100 * low, 100 * high, 2))} %`
    : decimals(value, decimalsOf(low, high, 4));
}

export const isShare = unit => /^share\b/.test(unit);

/** The part of a unit that is shown after a number with its percent sign. */
export const unitAfterPercent = (unit = '') =>
  isShare(unit) ? unit.replace(/^share ?/, '') : unit;

/** The value of a setting, a list or object included, in words. */
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

/** The names of settings, without those that say where another setting is from. */
export const settingNames = settings =>
  Object.keys(settings).filter(name => !name.endsWith('_from'));

/** The value of one of the settings in words, and where it is from if they say that. */
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
