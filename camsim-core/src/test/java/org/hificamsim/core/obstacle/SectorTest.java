package org.hificamsim.core.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SectorTest {
  @ParameterizedTest
  @CsvSource({"-1, -0.0, 0", "0, -3, 1", "5, 0, 2", "2, 2, 2.5", "0, 1, 3", "-7, 7, 3.5"})
  void measureRisesByOnePerQuarterCounterclockwise(double x, double y, double measure) {
    double size = Math.abs(x) + Math.abs(y);
    double measured = Sector.measure(x, y);
    assertEquals(measure, measured, 1e-15);
    assertEquals(x / size, Sector.x(measured), 1e-15);
    assertEquals(y / size, Sector.y(measured), 1e-15);
  }
}
