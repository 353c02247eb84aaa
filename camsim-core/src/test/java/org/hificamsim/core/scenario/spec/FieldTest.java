package org.hificamsim.core.scenario.spec;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FieldTest {
  private static final Field FIELD = new Field(-1, 4, 2, 8);

  @ParameterizedTest
  @CsvSource({
    "-1, 2, true",
    "4, 8, true",
    "-1.01, 3, false",
    "4.01, 3, false",
    "0, 1.99, false",
    "0, 8.01, false"
  })
  void containsItsBorder(double x, double y, boolean inside) {
    assertEquals(inside, FIELD.contains(x, y));
  }

  @Test
  void hasWidthAndHeight() {
    assertEquals(5, FIELD.width());
    assertEquals(6, FIELD.height());
  }
}
