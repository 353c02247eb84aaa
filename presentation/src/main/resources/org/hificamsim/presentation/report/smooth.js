// Smooths noisy curves by moving means.
/** The greatest number of entries that are not smoothed. */
export const MOST_RAW = 400;

const PARTS = 100;

/** The mean of each entry and up to `half` neighbours on either side. */
function movingMean(values, half) {
  const sums = [0];
  for (const value of values) sums.push(sums[sums.length - 1] + value);
  return values.map((value, i) => {
    const from = Math.max(0, i - half);
    const to = Math.min(values.length, i + half + 1);
    return (sums[to] - sums[from]) / (to - from);
  });
}

/** The moving mean over a hundredth of all entries; up to MOST_RAW entries stay as they are. */
export const smoothed = values =>
  values.length > MOST_RAW ? movingMean(values, Math.ceil(values.length / PARTS / 2)) : values;
