package org.hificamsim.profiling.boxes;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.apache.commons.math3.distribution.TDistribution;

/**
 * The share of some boxes that was found. The interval is over people, whose frames are nearly one
 * observation: the linearised variance of a ratio (Cochran, Sampling Techniques, 1977, 6.4).
 *
 * @param people the number of different people
 * @param found the share, NaN without a box
 * @param low the lower end of the 95 % interval; NaN with fewer than two people
 * @param high the upper end
 */
public record FoundShare(int boxes, int people, double found, double low, double high) {
  private static final double UPPER_QUANTILE = 0.975;

  /** Returns the share of some boxes. */
  public static FoundShare of(List<PersonBox> boxes) {
    Map<String, List<PersonBox>> byPerson =
        boxes.stream().collect(Collectors.groupingBy(PersonBox::person));
    double found = boxes.stream().mapToInt(PersonBox::found).average().orElse(Double.NaN);
    int people = byPerson.size();
    double squares =
        byPerson.values().stream()
            .mapToDouble(
                own -> {
                  double sum = own.stream().mapToInt(PersonBox::found).sum();
                  return (sum - found * own.size()) * (sum - found * own.size());
                })
            .sorted() // so that the sum does not depend on the order of a hash table
            .sum();
    double half =
        people < 2
            ? Double.NaN
            : new TDistribution(people - 1).inverseCumulativeProbability(UPPER_QUANTILE)
                * Math.sqrt(squares * people / (people - 1))
                / boxes.size();
    return new FoundShare(
        boxes.size(), people, found, Math.max(0, found - half), Math.min(1, found + half));
  }
}
