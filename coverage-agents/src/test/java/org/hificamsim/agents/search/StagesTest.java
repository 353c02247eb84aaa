package org.hificamsim.agents.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.core.metrics.Objective;
import org.junit.jupiter.api.Test;

/** Of 40,000 targets the weights of two k fit into a number: sixteen k in eight stages. */
class StagesTest {
  private static final int TARGETS = 40_000;

  @Test
  void theyDecideWhereNoneIsCutOffBelowTheScore() {
    Stages stages = stages("lexicographic", 20);
    assertEquals(8, stages.fill());
    assertTrue(stages.decide(8, 15));
    assertFalse(stages.decide(8, 16));
  }

  @Test
  void theyDecideWhereAllFit() {
    Stages stages = stages("lexicographic", 16);
    assertEquals(8, stages.fill());
    assertTrue(stages.decide(8, 16));
    Stages few = stages("lexicographic", 3);
    assertEquals(2, few.fill());
    assertTrue(few.decide(2, 3));
  }

  @Test
  void oneIsEnoughForASum() {
    Stages stages = stages("sum:cap=9", 20);
    assertEquals(1, stages.fill());
    assertTrue(stages.decide(1, 20));
  }

  /** All cameras cover the first target. */
  private static Stages stages(String objective, int cameras) {
    CoverageProblem problem = new CoverageProblem(cameras, cameras, TARGETS);
    problem.clear(TARGETS);
    long[] first = new long[problem.words()];
    first[0] = 1;
    for (int camera = 0; camera < cameras; camera++) {
      problem.addCamera();
      problem.addSet(first, 0);
    }
    Decisions decisions = new Decisions(problem);
    decisions.reset();
    return new Stages(Objective.parse(objective), problem, decisions);
  }
}
