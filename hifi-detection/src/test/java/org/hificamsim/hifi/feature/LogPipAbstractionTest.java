package org.hificamsim.hifi.feature;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;
import org.junit.jupiter.api.Test;

class LogPipAbstractionTest {
  private static LogPipAbstraction always(double response) {
    return (q, d, z) -> response;
  }

  @Test
  void pipIsTenToTheNegatedResponse() {
    assertEquals(0.01, always(2).pip(1, 1, 1), 1e-17);
    assertEquals(0.5, always(-Math.log10(0.5)).pip(1, 1, 1), 1e-15);
  }

  @Test
  void patchLargerThanTheImageFillsTheImage() {
    assertEquals(1, always(-0.2).pip(1, 1, 1));
    assertEquals(1, always(Double.NEGATIVE_INFINITY).pip(1, 1, 1));
  }

  @Test
  void nanStaysNan() {
    assertTrue(Double.isNaN(always(Double.NaN).pip(1, 1, 1)));
  }

  @Property
  void pipLiesBetweenZeroAndOne(@ForAll long bits) {
    double response = Double.longBitsToDouble(bits);
    double pip = always(response).pip(1, 1, 1);
    assertTrue(Double.isNaN(response) || (pip >= 0 && pip <= 1), () -> "pip " + pip);
  }

  @Property
  void pipNeverRisesWithTheResponse(
      @ForAll @Scale(9) @DoubleRange(min = -10, max = 400) double response,
      @ForAll @Scale(9) @DoubleRange(min = 0.001, max = 10) double more) {
    assertTrue(always(response + more).pip(1, 1, 1) <= always(response).pip(1, 1, 1));
  }
}
