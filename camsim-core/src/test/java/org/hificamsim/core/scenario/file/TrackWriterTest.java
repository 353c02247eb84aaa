package org.hificamsim.core.scenario.file;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import org.hificamsim.core.scenario.spec.Extent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TrackWriterTest {
  @Test
  void omitsTimesThatFollowTheInterval() throws IOException {
    StringBuilder text = new StringBuilder();
    TrackWriter out = new TrackWriter(text, 0.5, 0.125);
    out.target(7, 0.25);
    out.sample(2, 1, -1);
    out.sample(2.625, 1.5, 0); // the latest within the tolerance
    out.sample(2.875, 2, 1); // the earliest within the tolerance
    out.sample(3.75, 2, 2); // too late: needs its time
    out.sample(4.25, 2, 3);
    out.target(8, new Extent(0.5, 2));
    out.sample(4.75, 9, 9); // times start again for each target
    assertEquals(
        """
        tracks 1
        interval 0.5
        target 7 size 0.25
        2 1 -1
        1.5 0
        2 1
        3.75 2 2
        2 3
        target 8 width 0.5 height 2
        4.75 9 9
        """,
        text.toString());
  }

  @ParameterizedTest
  @CsvSource({
    "3.0, 3",
    "-3.0, -3",
    "0.0, 0",
    "-0.0, -0.0",
    "0.1, 0.1",
    "9999999, 9999999",
    "1e7, 10000000",
    "-1e7, -10000000",
    "NaN, NaN"
  })
  void writesShortestNumbers(double value, String text) {
    assertEquals(text, TrackWriter.plain(value));
  }
}
