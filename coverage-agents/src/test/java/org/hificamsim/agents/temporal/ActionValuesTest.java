package org.hificamsim.agents.temporal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.hificamsim.agents.choice.Ties;
import org.hificamsim.agents.toy.ToyNetwork;

class ActionValuesTest {
  @Property(tries = 200)
  void theBestActionIsFoundAfterAnyUpdates(
      @ForAll @IntRange(min = 1, max = 6) int levels, @ForAll Ties ties, @ForAll long seed) {
    TemporalDifferenceSettings settings =
        new TemporalDifferenceSettings(
            StateReading.COUNT, RewardReading.COUNT_CHANGE, 0.1, 0.9, 1, 0, ties);
    ActionValues values = new ActionValues(new ToyNetwork(2, levels), settings);
    SplittableRandom random = new SplittableRandom(seed);
    int row = values.row(0, 0, 1);
    double[] plain = new double[levels];
    for (int i = 0; i < 100; i++) {
      int action = random.nextInt(levels);
      double alpha = random.nextInt(3) / 2.0;
      double target = random.nextInt(-3, 4); // few values, so that many are equal
      plain[action] += alpha * (target - plain[action]);
      values.learn(0, row, action, alpha, target);
      assertEquals(ties.best(plain, 0, levels), values.best(0, row, levels), "update " + i);
    }
  }
}
