package org.hificamsim.reproduction;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.hificamsim.runs.Estimate;
import org.junit.jupiter.api.Test;

class VerdictTest {
  @Test
  void numberIsReproducedWithinFiveHundredths() {
    assertEquals(Verdict.REPRODUCED, Verdict.of(new Estimate(0.55, 0.55, 0.55), 0.50));
    assertEquals(Verdict.REPRODUCED, Verdict.of(new Estimate(0.45, 0.44, 0.46), 0.50));
    assertEquals(Verdict.NOT_REPRODUCED, Verdict.of(new Estimate(0.551, 0.55, 0.56), 0.50));
  }

  @Test
  void fartherNumberMayBeWithinInterval() {
    assertEquals(Verdict.WITHIN_INTERVAL, Verdict.of(new Estimate(0.60, 0.50, 0.70), 0.50));
    assertEquals(Verdict.NOT_REPRODUCED, Verdict.of(new Estimate(0.60, 0.51, 0.70), 0.50));
  }

  @Test
  void missingNumberIsNotReproduced() {
    double none = Double.NaN;
    assertEquals(Verdict.NOT_REPRODUCED, Verdict.of(new Estimate(none, none, none), 0.5));
  }

  @Test
  void singleRunDecidesNoStatement() {
    assertEquals(Verdict.WITHIN_INTERVAL, Verdict.of(List.of(Estimate.single(0.5))));
    assertEquals(Verdict.WITHIN_INTERVAL, Verdict.of(List.of(Estimate.single(-0.5))));
  }

  @Test
  void statementNeedsAllMargins() {
    Estimate clear = new Estimate(0.2, 0.1, 0.3);
    Estimate open = new Estimate(0.1, -0.1, 0.3);
    Estimate against = new Estimate(-0.2, -0.3, -0.1);
    assertEquals(Verdict.REPRODUCED, Verdict.of(List.of(clear, clear)));
    assertEquals(Verdict.WITHIN_INTERVAL, Verdict.of(List.of(clear, open)));
    assertEquals(Verdict.NOT_REPRODUCED, Verdict.of(List.of(clear, open, against)));
  }
}
