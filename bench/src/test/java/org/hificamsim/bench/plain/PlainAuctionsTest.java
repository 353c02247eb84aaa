package org.hificamsim.bench.plain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.bench.AuctionRun;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.network.NetworkRun;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.statistics.StepFigures;
import org.hificamsim.runs.generate.RandomField;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares the plain auctions with the engine, step by step. */
class PlainAuctionsTest {
  private static final int STEPS = 500;

  /** The greatest difference of sums, which are added in another order. */
  private static final double ROUNDING = 1e-9;

  @ParameterizedTest
  @ValueSource(ints = {15, 100})
  void everyStepHasFiguresOfEngine(int cameras) {
    Scenario field = new RandomField(cameras, cameras / 2, RandomField.CLUSTER_AREA, 1).scenario();
    NetworkRun ours = AuctionRun.of(field, ScheduleKind.PASSIVE, 0);
    PlainAuctions plain = new PlainAuctions(field, 0);
    long handovers = 0;
    for (int step = 0; step < STEPS; step++) {
      ours.simulation().step();
      StepFigures expected = ours.network().figures();
      PlainAuctions.Figures figures = plain.step();
      handovers += figures.handovers();
      assertEquals(expected.utility(), figures.utility(), ROUNDING, "step " + step);
      assertEquals(expected.communication(), figures.communication(), "step " + step);
      assertEquals(expected.confidence(), figures.confidence(), ROUNDING, "step " + step);
      assertEquals(expected.proportion(), figures.proportion(), "step " + step);
      assertEquals(expected.handovers(), figures.handovers(), "step " + step);
    }
    assertTrue(handovers > 20, handovers + " handovers");
  }
}
