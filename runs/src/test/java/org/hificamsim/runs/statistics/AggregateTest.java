package org.hificamsim.runs.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.hificamsim.runs.Estimate;
import org.junit.jupiter.api.Test;

class AggregateTest {
  private static final Strata TWO_SCENARIOS =
      Strata.of(List.of(new double[] {0, 0.2, 0.4, 0.6}, new double[] {0.5, 0.7, 0.9, 1.3}));

  @Test
  void interquartileMeanOmitsLowestAndHighestQuarter() {
    assertEquals((0.4 + 0.5 + 0.6 + 0.7) / 4, Aggregate.IQM.of(TWO_SCENARIOS).mean(), 1e-12);
  }

  @Test
  void optimalityGapIgnoresScoresAboveOne() {
    assertEquals(1 - (1.2 + 2.1 + 1) / 8, Aggregate.OPTIMALITY_GAP.of(TWO_SCENARIOS).mean(), 1e-12);
  }

  @Test
  void meanAndMedianUseMeansOfScenarios() {
    Strata uneven = Strata.of(List.of(new double[] {0, 1}, new double[] {1}, new double[] {1}));
    assertEquals(2.5 / 3, Aggregate.MEAN.of(uneven).mean(), 1e-12);
    assertEquals(1, Aggregate.MEDIAN.of(uneven).mean(), 1e-12);
  }

  @Test
  void omitsRunsWithoutScore() {
    Strata gaps =
        Strata.of(List.of(new double[] {Double.NaN, 0.5}, new double[] {Double.NaN, Double.NaN}));
    assertEquals(1, gaps.runs());
    assertEquals(1, gaps.scenarios());
    for (Aggregate aggregate : Aggregate.values()) {
      assertEquals(0.5, aggregate.of(gaps).mean(), 1e-12);
    }
  }

  @Test
  void drawsSeedsWithinTheirScenario() {
    Strata apart = Strata.of(List.of(new double[] {0, 0, 0}, new double[] {1, 1, 1}));
    Estimate mean = Aggregate.estimates(apart).get(Aggregate.MEAN);
    assertEquals(new Estimate(0.5, 0.5, 0.5), mean);
  }

  @Test
  void intervalContainsValueAndIsReproducible() {
    Estimate iqm = Aggregate.estimates(TWO_SCENARIOS).get(Aggregate.IQM);
    assertTrue(iqm.low() < iqm.mean() && iqm.mean() < iqm.high(), iqm.toString());
    assertEquals(iqm, Aggregate.estimates(TWO_SCENARIOS).get(Aggregate.IQM));
  }

  @Test
  void intervalOfInterquartileMeanStaysWithinScores() {
    Strata few = Strata.of(List.of(new double[] {0.31, 0.33, 0.48, 0.5, 0.504}));
    Estimate iqm = Aggregate.estimates(few).get(Aggregate.IQM);
    assertTrue(iqm.low() >= 0.31 && iqm.high() <= 0.504, iqm.toString());
  }

  @Test
  void intervalsStayWithinPossibleValues() {
    Strata low = Strata.of(List.of(new double[] {0, 0, 0, 0.05, 0.9}));
    assertEquals(0, Aggregate.MEAN.of(low).low());
    assertEquals(1, Aggregate.OPTIMALITY_GAP.of(low).high());
  }

  @Test
  void singleScenarioHasMeanOfTablesAndNoMedian() {
    double[] scores = {0.38, 0.41, 0.42, 0.42, 0.42, 0.42, 0.42, 0.42, 0.42, 0.43};
    Map<Aggregate, Estimate> estimates = Aggregate.estimates(Strata.of(List.of(scores)));
    Estimate mean = Estimate.mean(scores);
    assertEquals(mean.mean(), estimates.get(Aggregate.MEAN).mean(), 1e-15);
    assertEquals(mean.low(), estimates.get(Aggregate.MEAN).low(), 1e-15);
    assertEquals(mean.high(), estimates.get(Aggregate.MEAN).high(), 1e-15);
    assertEquals(1 - mean.low(), estimates.get(Aggregate.OPTIMALITY_GAP).high(), 1e-15);
    assertFalse(estimates.containsKey(Aggregate.MEDIAN));
  }

  @Test
  void oneSeedHasNoInterval() {
    Strata single = Strata.of(List.of(new double[] {0.3}, new double[] {0.7}));
    assertEquals(
        new Estimate(0.5, Double.NaN, Double.NaN), Aggregate.estimates(single).get(Aggregate.MEAN));
  }

  @Test
  void isNaNWithoutRuns() {
    Strata none = Strata.of(List.of(new double[0]));
    for (Aggregate aggregate : Aggregate.values()) {
      assertTrue(Double.isNaN(aggregate.of(none).mean()), aggregate.label());
    }
  }
}
