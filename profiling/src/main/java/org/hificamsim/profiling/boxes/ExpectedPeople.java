package org.hificamsim.profiling.boxes;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.apache.commons.math3.stat.correlation.PearsonsCorrelation;
import org.hificamsim.profiling.fit.Reliability;

/**
 * The chances that a detection gives to people in the simulated picture, compared with those that a
 * detector found in the real one.
 *
 * @param detection the name of the detection
 * @param people the people of all frames
 * @param chances the chance of each of them, in the same order
 */
public record ExpectedPeople(String detection, List<PersonBox> people, double[] chances) {
  /**
   * The sums over one frame or one person.
   *
   * @param boxes the number of boxes
   * @param expected the sum of their chances
   * @param found the number that was found
   */
  public record Sums(int boxes, double expected, int found) {
    Sums plus(double chance, int more) {
      return new Sums(boxes + 1, expected + chance, found + more);
    }
  }

  /** Returns the chances and outcomes of all boxes. */
  public Reliability reliability() {
    return new Reliability(chances, people.stream().mapToDouble(PersonBox::found).toArray());
  }

  /** Returns the sums by frame, in the order of the recording. */
  public Map<Long, Sums> byFrame() {
    return by(PersonBox::frame);
  }

  /** Returns the sums by person, in the order of appearance. */
  public Map<String, Sums> byPerson() {
    return by(PersonBox::person);
  }

  private <K> Map<K, Sums> by(Function<PersonBox, K> key) {
    Map<K, Sums> sums = new LinkedHashMap<>();
    for (int i = 0; i < chances.length; i++) {
      PersonBox box = people.get(i);
      Sums before = sums.getOrDefault(key.apply(box), new Sums(0, 0, 0));
      sums.put(key.apply(box), before.plus(chances[i], box.found()));
    }
    return sums;
  }

  /**
   * Returns the correlation over frames of the expected and the found number of people; NaN if one
   * of them never varies.
   */
  public double correlation() {
    double[] expected = byFrame().values().stream().mapToDouble(Sums::expected).toArray();
    double[] found = byFrame().values().stream().mapToDouble(Sums::found).toArray();
    return expected.length < 2
        ? Double.NaN
        : new PearsonsCorrelation().correlation(expected, found);
  }
}
