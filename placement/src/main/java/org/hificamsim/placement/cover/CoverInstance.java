package org.hificamsim.placement.cover;

import java.util.Arrays;

/**
 * A covering problem: candidates, each with its price and the samples that it sees.
 *
 * @param units by sample: what each time that it is seen is worth, 0 or more
 * @param needs by sample: how many times count, its redundancy k, 0 or more
 * @param columns by candidate: the samples that it sees, rising
 * @param prices by candidate, above 0
 */
public record CoverInstance(double[] units, int[] needs, int[][] columns, double[] prices) {
  /** A number of samples, each worth 1 where it is seen once. */
  public static CoverInstance of(int samples, int[][] columns, double[] prices) {
    double[] units = new double[samples];
    int[] needs = new int[samples];
    Arrays.fill(units, 1);
    Arrays.fill(needs, 1);
    return new CoverInstance(units, needs, columns, prices);
  }

  /** How many samples there are. */
  public int samples() {
    return units.length;
  }

  /** How many candidates there are. */
  public int candidates() {
    return columns.length;
  }

  /** How often each sample is seen by these candidates. */
  public int[] counts(int[] chosen) {
    int[] counts = new int[samples()];
    for (int candidate : chosen) {
      for (int sample : columns[candidate]) {
        counts[sample]++;
      }
    }
    return counts;
  }

  /** What it is worth to see each sample as often as this. */
  public double worth(int[] counts) {
    double worth = 0;
    for (int sample = 0; sample < counts.length; sample++) {
      worth += units[sample] * Math.min(needs[sample], counts[sample]);
    }
    return worth;
  }

  /** What it adds to see these samples once more, where each is seen as often as this. */
  public double gain(int[] counts, int[] seen) {
    return Arrays.stream(seen)
        .filter(sample -> counts[sample] < needs[sample])
        .mapToDouble(sample -> units[sample])
        .sum();
  }

  /** What it is worth to see every sample as often as it counts. */
  public double total() {
    return worth(needs);
  }

  /** What these candidates cost. */
  public double price(int[] chosen) {
    return Arrays.stream(chosen).mapToDouble(candidate -> prices[candidate]).sum();
  }

  /** What is left to do where samples are seen this often by others, who stay. */
  public CoverInstance after(int[] counts) {
    int[] left = new int[needs.length];
    Arrays.setAll(left, sample -> Math.max(0, needs[sample] - counts[sample]));
    return new CoverInstance(units, left, columns, prices);
  }

  /** The same without what no candidate can see: a sample needs as many as see it at most. */
  public CoverInstance coverable() {
    int[] most = new int[samples()];
    for (int[] column : columns) {
      for (int sample : column) {
        most[sample]++;
      }
    }
    int[] can = new int[needs.length];
    Arrays.setAll(can, sample -> Math.min(needs[sample], most[sample]));
    return new CoverInstance(units, can, columns, prices);
  }

  /** The same without candidates that no plan needs, as others see all that they see. */
  public CoverInstance undominated() {
    return with(Dominance.left(this));
  }

  /** The same with these candidates alone. */
  CoverInstance with(int[] candidates) {
    return new CoverInstance(
        units,
        needs,
        Arrays.stream(candidates).mapToObj(one -> columns[one]).toArray(int[][]::new),
        Arrays.stream(candidates).mapToDouble(one -> prices[one]).toArray());
  }
}
