// The names that people read, for those that files have: the latter stand in tooltips.
import {el} from './dom.js';
import {decimals, percent} from './numbers.js';

const RULES = {chance: 'by chance', probability: 'by probability', threshold: 'by threshold'};
const LAWS = {
  lin: 'linear',
  sr: 'symbolic',
  'svr-lin': 'linear support vectors',
  'svr-rbf': 'RBF support vectors',
  power: 'power law',
  pinhole: 'pinhole law',
};

/** The name of a file's column or setting in words. */
export const words = name => name.replaceAll('_', ' ');

/** A policy, a detection or an objective in words: hifi:orb-lin@chance, covered:k=2. */
export function spelled(spec) {
  const [, what, rule] = /^(.*?)(?:@([a-z0-9.].*))?$/.exec(spec);
  const [name, options = ''] = what.split(/:(.*)/);
  const parts = [
    ...(/^(hifi|lab)$/.test(name) ? [fitted(name, options)] : [name, ...options.split(',')]),
    ...(rule ? rule.split(/[:,]/).map(part => RULES[part] ?? part) : []),
  ];
  return parts
    .filter(Boolean)
    .map(part => part.replace('=', ' '))
    .join(', ');
}

/** A model that was fitted: the detector, the law of its focal length, and the equation of its line. */
function fitted(family, text) {
  const [, detector, law, line] = /^([^-]+)-(.*?)(-gt)?$/.exec(text) ?? [null, text, ''];
  return `${detector.toUpperCase()} ${LAWS[law] ?? law}${line ? ', chapter 5' : ''}${family === 'lab' ? ', from the laboratory' : ''}`;
}

/** A number with its unit: shares as percentages. */
export const withUnit = (value, unit = '') =>
  !Number.isFinite(value)
    ? '–'
    : isShare(unit)
      ? `${decimals(100 * value, 2)} %`
      : decimals(value, 4);

export const isShare = unit => /^share\b/.test(unit);

/** The low and high end of a metric's interval, held to what the metric can be. */
export const held = (name, unit, {mean, low, high}) =>
  name === 'regret' || low === ''
    ? {low, high}
    : {low: low < 0 ? 0 : low, high: isShare(unit) && high > Math.max(1, mean) ? 1 : high};

/** What a unit says next to a number that has its percent sign. */
export const besideUnit = (unit = '') => (isShare(unit) ? unit.replace(/^share ?/, '') : unit);

/** The value of a setting in words, whatever it holds. */
export function told(value) {
  if (Array.isArray(value))
    return (
      value
        .map(told)
        .join(value.some(one => one !== null && typeof one === 'object') ? '; ' : ' ') || 'none'
    );
  if (value !== null && typeof value === 'object')
    return Object.entries(value)
      .map(([name, part]) => `${words(name)} ${told(part)}`)
      .join(', ');
  return String(value ?? '–');
}

/** A text with the raw name in its tooltip, where that is another one. */
export const tipped = (text, raw) => el('span', {title: raw === text ? null : raw}, text);

/** A score per step as a number. */
export const scoreNumber = (score, {share}) => (share ? percent(score) : decimals(score, 2));

/** A score per step in the objective's own words. */
export const scoreText = (score, objective) =>
  `${objective.title}: ${scoreNumber(score, objective)}`;
