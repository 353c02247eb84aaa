// Numbers as text.

/** A number with at most `most` decimals, a dash if it is not finite. */
export function decimals(number, most = 2) {
  return Number.isFinite(number) ? String(Number(number.toFixed(most))) : '–';
}

/** The decimals at which the half of an interval has two digits; at most `most`. */
export const decimalsOf = (low, high, most) =>
  high > low ? Math.max(0, Math.min(most, 1 - Math.floor(Math.log10((high - low) / 2)))) : most;

/** A number with so many significant digits at most; three suit a threshold. */
export const significant = (number, digits = 3) => String(Number(number.toPrecision(digits)));

/**
 * A number of a table: three decimals, fewer from ten on, and one significant digit below a
 * thousandth.
 */
export function tableNumber(number) {
  const size = Math.abs(number);
  if (size > 0 && size < 5e-4) return significant(number, 1);
  return number.toFixed(size < 10 ? 3 : size < 1000 ? 1 : 0);
}

/** A length in metres, to the millimetre. */
export const metres = number => `${number.toFixed(3)} m`;

/** A share as a percentage. */
export const percent = share => `${decimals(100 * share, 1)} %`;

/** Radians as whole degrees, with a sign. */
export const signed = radians => {
  const degrees = Math.round((radians * 180) / Math.PI);
  return `${degrees > 0 ? '+' : degrees < 0 ? '−' : ''}${Math.abs(degrees)}°`;
};
