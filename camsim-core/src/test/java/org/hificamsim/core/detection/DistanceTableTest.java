package org.hificamsim.core.detection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

class DistanceTableTest {
  private static final double RADIUS = 13;

  @Test
  void tabulatesSmoothFunctionOnce() {
    AtomicInteger evaluations = new AtomicInteger();
    DoubleUnaryOperator smooth = distance -> Math.exp(-distance / 5);
    DistanceTable table =
        table(
            distance -> {
              evaluations.incrementAndGet();
              return smooth.applyAsDouble(distance);
            });
    int before = evaluations.get();
    assertClose(smooth, table, 1e-8);
    assertEquals(before, evaluations.get());
  }

  @Test
  void evaluatesFunctionDirectlyAtJumps() {
    DoubleUnaryOperator jumps = distance -> distance < 4.0001 ? 1 : distance / 100;
    assertClose(jumps, table(jumps), 1e-8);
  }

  @Test
  void includesBothEnds() {
    DistanceTable table = table(distance -> distance * distance);
    assertEquals(0, table.value(0), 1e-8);
    assertEquals(RADIUS * RADIUS, table.value(RADIUS), 1e-6);
  }

  @Test
  void keepsNaN() {
    DistanceTable table = table(distance -> distance < 6 ? Double.NaN : 0.5);
    assertTrue(Double.isNaN(table.value(3)));
    assertEquals(0.5, table.value(9));
  }

  private static DistanceTable table(DoubleUnaryOperator function) {
    return DistanceTable.of(RADIUS, function);
  }

  private static void assertClose(
      DoubleUnaryOperator function, DistanceTable table, double tolerance) {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 10_000; i++) {
      double distance = random.nextDouble() * RADIUS;
      assertEquals(
          function.applyAsDouble(distance), table.value(distance), tolerance, distance + " m");
    }
  }
}
