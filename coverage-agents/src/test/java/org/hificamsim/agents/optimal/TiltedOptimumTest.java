package org.hificamsim.agents.optimal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import java.util.SplittableRandom;
import org.hificamsim.agents.CoveragePolicies;
import org.hificamsim.agents.toy.RealWorld;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.api.Test;

/**
 * Tests two tilting cameras above a shelf: the optimum has the score of the best of all
 * configurations, each of which is simulated.
 */
class TiltedOptimumTest {
  private static final String SITE =
      "<obstacles><wall x1='-6' y1='1.003' x2='6' y2='1.003' height='1.8'/></obstacles>"
          + "<optics name='o' hfov='25 45' reach='25' pan='-20 20' tilt='0 22'/>"
          + "<camera name='a' x='0' y='-9' z='6' tilt='10' heading='0' viewing_angle='60' range='9'"
          + " optics='o'/>"
          + "<camera name='b' x='3' y='9' z='7' tilt='10' heading='200' viewing_angle='60'"
          + " range='9' optics='o'/>";
  private static final int VIEWS = 8;

  private final Registry<ZoomPolicy> registry = CoveragePolicies.register(new Registry<>("policy"));

  @Test
  void findsTheBestOfAllTiltedConfigurations() {
    SplittableRandom random = new SplittableRandom(7);
    int tiltPays = 0;
    for (int world = 0; world < 30; world++) {
      String parts = SITE + targets(world, random);
      double best = 0;
      double bestAtFirstTilt = 0;
      for (int a = 0; a < VIEWS; a++) {
        for (int b = 0; b < VIEWS; b++) {
          double score = score(parts, RealWorld.always(a, b));
          best = Math.max(best, score);
          boolean firstTilt = a % 4 < 2 && b % 4 < 2;
          bestAtFirstTilt = firstTilt ? Math.max(bestAtFirstTilt, score) : bestAtFirstTilt;
        }
      }
      assertEquals(best, score(parts, registry.create("optimal")), 1e-12, parts);
      tiltPays += best > bestAtFirstTilt ? 1 : 0;
    }
    assertTrue(tiltPays > 4, "few worlds in which the second tilt pays: " + tiltPays);
  }

  private static String targets(int world, SplittableRandom random) {
    StringBuilder targets = new StringBuilder();
    for (int i = 1; i <= 1 + world % 2; i++) {
      targets.append(
          String.format(
              Locale.ROOT,
              "<object features='%d' x='%.2f' y='%.2f' heading='0' speed='0' width='0.5'"
                  + " height='1.7' seen='head'/>",
              i,
              random.nextDouble(-6, 6),
              random.nextDouble(-6, 6)));
    }
    return targets.toString();
  }

  private static double score(String parts, ZoomPolicy policy) {
    Simulation run = RealWorld.run(parts, policy, 1);
    run.step();
    return run.coverage().score();
  }
}
