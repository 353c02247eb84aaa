package org.hificamsim.network.bandit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Random;
import org.hificamsim.core.Reference;
import org.hificamsim.network.agent.Named;
import org.junit.jupiter.api.Test;

/**
 * Tests that each bandit chooses the arms that CamSim recorded, with the same counts and rewards.
 */
class CamSimBanditTest {
  private static final double TOLERANCE = 1e-9;

  @Test
  void armsCountsAndRewardsEqualRecording() {
    List<String[]> rows = Reference.rows("camsim/outputs/bandits.csv");
    BanditSolver solver = null;
    for (String[] row : rows) {
      int step = Integer.parseInt(row[3]);
      if (step == 0) {
        solver = solver(row[0], Long.parseLong(row[1]), Integer.parseInt(row[2]));
      }
      String where = String.join(",", List.of(row).subList(0, 4));
      int arm = solver.select();
      assertEquals(Integer.parseInt(row[4]), arm, where);
      for (int i = 0; i < Arms.COUNT; i++) {
        assertEquals(
            Integer.parseInt(row[7 + i]), solver.arms().count(i) - 1, where + " count " + i);
        assertEquals(
            Double.parseDouble(row[13 + i]),
            solver.arms().reward(i),
            TOLERANCE,
            where + " reward " + i);
      }
      double performance = ((7 * arm + 3 * step) % 11) / 10.0;
      double communication = (5 * arm + step) % 13;
      assertEquals(Double.parseDouble(row[5]), performance, where);
      assertEquals(Double.parseDouble(row[6]), communication, where);
      solver.feed(performance, communication);
    }
    assertEquals(6000, rows.size());
  }

  private static BanditSolver solver(String name, long seed, int interval) {
    BanditAlgorithm algorithm = Named.find(BanditAlgorithm.class, name).orElseThrow();
    return new BanditSolver(
        algorithm, new BanditParameters(0.1, 0.5, 0, 0, interval), new Random(seed));
  }
}
