// The words that people read for names in files; tooltips have the names themselves. SpokenNames
// writes WORDS.
import {el} from './dom.js';
import {decimals, decimalsOf, percent, significant} from './numbers.js';

/** The user's own words for policies and detections. */
let labels = {};

export const useLabels = own => (labels = own ?? {});

/** The name of a column or setting in words. */
export const words = name => name.replaceAll('_', ' ');

/** A policy, detection or objective, such as hifi:orb-lin@chance or covered:k=2, in words. */
export function spelled(spec) {
  if (Object.hasOwn(labels, spec)) return labels[spec];
  const [, what, rule] = /^(.*?)(?:@([a-z0-9.].*))?$/.exec(spec);
  const [name, options = ''] = what.split(/:(.*)/);
  const parts = [
    ...(/^(hifi|lab)$/.test(name)
      ? [fitted(name, options)]
      : [WORDS.models[name] ?? name, ...options.split(',')]),
    ...(rule ? rule.split(/[:,]/).map(part => WORDS.rules[part] ?? part) : []),
  ];
  return parts
    .filter(Boolean)
    .map(part => part.replace('=', ' '))
    .join(', ');
}

/** A fitted model in words: its detector, the law of its focal length, the chapter of its line. */
function fitted(family, text) {
  const [, detector, law, line] = /^([^-]+)-(.*?)(-gt)?$/.exec(text) ?? [null, text, ''];
  const chapter = line ? ', chapter 5' : '';
  const origin = family === 'lab' ? ', from the laboratory' : '';
  return `${detector.toUpperCase()} ${WORDS.laws[law] ?? law}${chapter}${origin}`;
}

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

/** A text with the raw name in its tooltip, if that differs. */
export const tipped = (text, raw) => el('span', {title: raw === text ? null : raw}, text);

/** A score per step as text: a percentage if the objective is a share. */
export const scoreNumber = (score, {share}) => (share ? percent(score) : decimals(score, 2));

/** A score per step after the objective's title. */
export const scoreText = (score, objective) =>
  `${objective.title}: ${scoreNumber(score, objective)}`;
