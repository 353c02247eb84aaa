package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AngleBracketTest {
  @Property
  void holdsTheArcCosine(@ForAll @DoubleRange(min = -1, max = 1) double cosine) {
    assertHolds(cosine);
  }

  @Test
  void holdsTheArcCosineAllAlong() {
    for (int i = -1_000_000; i <= 1_000_000; i++) {
      assertHolds(i / 1e6);
    }
    for (double off = 1; off > 1e-17; off /= 1.01) {
      assertHolds(1 - off);
      assertHolds(off - 1);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, 1.0000000000000002, -1.0000000000000002, 7})
  void isNoAngleWhereTheArcCosineIsNone(double cosine) {
    assertEquals(Double.NaN, AngleBracket.lower(AngleBracket.about(cosine)));
    assertEquals(Double.NaN, AngleBracket.upper(AngleBracket.about(cosine)));
  }

  private static void assertHolds(double cosine) {
    double angle = Math.acos(cosine);
    double lower = AngleBracket.lower(AngleBracket.about(cosine));
    double upper = AngleBracket.upper(AngleBracket.about(cosine));
    assertTrue(lower <= angle && angle <= upper, () -> lower + " " + angle + " " + upper);
    assertTrue(upper - lower <= 2.001 * AngleBracket.ERROR, "wide at " + cosine);
  }
}
