package org.hificamsim.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

class RunSummaryTest {
  @Test
  void barsAreProportionalToValues() {
    double[] values = {0, 1, 2, 3, 4, 5, 6, 7};
    assertEquals("▁▂▃▄▅▆▇█  (▁ 0 to █ 7.00)", RunSummary.bars(values, StandardCharsets.UTF_8));
  }

  @Test
  void usesAsciiWithoutUnicode() {
    double[] values = {0.5, 0, 0.25};
    assertEquals("#_=  (_ 0 to # 0.50)", RunSummary.bars(values, StandardCharsets.US_ASCII));
    assertEquals("#_=  (_ 0 to # 0.50)", RunSummary.bars(values, StandardCharsets.ISO_8859_1));
  }

  @Test
  void zerosHaveLowestBars() {
    assertEquals("__  (_ 0 to # 0.00)", RunSummary.bars(new double[2], StandardCharsets.US_ASCII));
  }
}
