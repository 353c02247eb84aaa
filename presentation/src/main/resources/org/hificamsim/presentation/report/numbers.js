// Writes numbers as text.
/** A number with at most `most` decimals; a dash if it is not finite. */
export function decimals(number, most = 2) {
  return Number.isFinite(number) ? String(Number(number.toFixed(most))) : '–';
}

/**
 * The number of decimals that shows half of an interval with two digits; `most` if that is less, or
 * if the interval is empty.
 */
export const decimalsOf = (low, high, most) =>
  high > low ? Math.max(0, Math.min(most, 1 - Math.floor(Math.log10((high - low) / 2)))) : most;

/** A number with at most `digits` significant digits. */
export const significant = (number, digits = 3) => String(Number(number.toPrecision(digits)));

/**
 * A number for a table: three decimals; one from 10 on, none from 1000 on; one significant digit
 * below half a thousandth.
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

/** An angle in radians as whole degrees with a sign. */
export const signedDegrees = radians => {
  const degrees = Math.round((radians * 180) / Math.PI);
  return `${degrees > 0 ? '+' : degrees < 0 ? '−' : ''}${Math.abs(degrees)}°`;
};
