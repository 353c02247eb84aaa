package org.hificamsim.runs;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

class MetricTest {
  @Test
  void titlesDistinguishMetrics() {
    long titles = Arrays.stream(Metric.values()).map(Metric::title).distinct().count();
    assertEquals(Metric.values().length, titles);
  }

  @Test
  void titlesUseOneNameForTheSumOfKMin() {
    assertEquals("summed k_min", Metric.PERFORMANCE.title());
    assertEquals("expected summed k_min", Metric.EXPECTED_PERFORMANCE.title());
    assertEquals("summed k_min bound", Metric.PERFORMANCE_BOUND.title());
  }
}
