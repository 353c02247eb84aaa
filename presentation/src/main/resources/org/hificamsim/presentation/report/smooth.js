// Means over a window of neighbours: what a noisy curve tends to.

/** This many entries are shown as they are. */
export const SHOWN_RAW = 400;

const PARTS = 100;

/** The mean of each entry and of `half` neighbours on either side, as far as there are some. */
export function movingMean(values, half) {
  const sums = [0];
  for (const value of values) sums.push(sums[sums.length - 1] + value);
  return values.map((value, i) => {
    const from = Math.max(0, i - half);
    const to = Math.min(values.length, i + half + 1);
    return (sums[to] - sums[from]) / (to - from);
  });
}

/** The moving mean over a hundredth of all entries; of few entries, the entries. */
export const smoothed = values =>
  values.length > SHOWN_RAW ? movingMean(values, Math.ceil(values.length / PARTS / 2)) : values;
