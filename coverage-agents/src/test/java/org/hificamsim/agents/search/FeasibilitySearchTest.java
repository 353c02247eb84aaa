package org.hificamsim.agents.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.hificamsim.agents.search.FeasibilitySearch.Outcome;
import org.junit.jupiter.api.Test;

class FeasibilitySearchTest {
  private static final int TARGETS = 9;

  @Test
  void tellsPossibleCoveragesFromImpossibleOnesWhateverTheWeights() {
    SplittableRandom random = new SplittableRandom(1);
    long nodes = 0;
    for (int trial = 0; trial < 3_000; trial++) {
      long[][] sets = Problems.random(random, 8, 4, TARGETS, 0.2 + 0.5 * random.nextDouble());
      CoverageProblem problem = Problems.problem(TARGETS, sets);
      Domains domains = new Domains(problem);
      domains.reset();
      if (trial % 2 > 0) {
        domains.weigh(random.longs(TARGETS, 0, 100).toArray());
      }
      FeasibilitySearch search = new FeasibilitySearch(problem, domains);
      Choice found = new Choice(problem);
      int best = Exhaustive.solve(TARGETS, sets).value();
      assertTrue(domains.bound() >= best);
      for (int k = 0; k <= sets.length; k++) {
        boolean possible =
            domains.require(k) && search.search(Long.MAX_VALUE, found) == Outcome.FOUND;
        assertEquals(k <= best, possible, "coverage " + k + " of " + Exhaustive.text(sets));
        assertTrue(!possible || found.least() >= k);
        domains.undo(0);
      }
      nodes += search.nodes();
    }
    assertTrue(nodes > 3_000, "searched only " + nodes + " nodes");
  }

  @Test
  void leavesUndecidedWhatItsNodesDoNotSuffice() {
    SplittableRandom random = new SplittableRandom(2);
    int undecided = 0;
    for (int trial = 0; trial < 1_000; trial++) {
      long[][] sets = Problems.random(random, 8, 4, TARGETS, 0.4);
      CoverageProblem problem = Problems.problem(TARGETS, sets);
      Domains domains = new Domains(problem);
      domains.reset();
      FeasibilitySearch search = new FeasibilitySearch(problem, domains);
      int best = Exhaustive.solve(TARGETS, sets).value();
      if (domains.require(best + 1)) {
        Outcome outcome = search.search(2, new Choice(problem));
        assertTrue(outcome != Outcome.FOUND);
        assertTrue(search.nodes() <= 2);
        undecided += outcome == Outcome.UNDECIDED ? 1 : 0;
      }
    }
    assertTrue(undecided > 0, "two nodes always sufficed");
  }
}
