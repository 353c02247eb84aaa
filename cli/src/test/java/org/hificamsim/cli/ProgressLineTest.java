package org.hificamsim.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The progress of a run in one line. */
class ProgressLineTest {
  private static final long TEN_SECONDS = TimeUnit.SECONDS.toNanos(10);

  private final ProgressLine line = new ProgressLine("run ring", "steps", 8_000_000);

  @Test
  void tellsSpeedAndTheTimeLeftAtThatSpeed() {
    assertEquals(
        "run ring: 2000000 of 8000000 steps (25%), 200000 steps/s, 0:00:30 left",
        line.plain(2_000_000, TEN_SECONDS));
    assertEquals(
        "compare: 1 of 3000 runs (0%), 0.1 runs/s, 8:19:50 left",
        new ProgressLine("compare", "runs", 3000).plain(1, TEN_SECONDS));
  }

  @Test
  void theBarFillsTheRoomThatIsLeft() {
    String bar = line.bar(2_000_000, TEN_SECONDS, 100);
    assertEquals(100, bar.length());
    int full = (int) bar.chars().filter(c -> c == '=').count();
    int room = bar.indexOf(']') - bar.indexOf('[') - 1;
    assertEquals(room / 4, full);
    assertTrue(bar.endsWith("] 2000000 of 8000000 steps, 200000 steps/s, 0:00:30 left"), bar);
  }

  @Test
  void whatWasDoneBeforeSaysNothingOfTheSpeed() {
    ProgressLine resumed = new ProgressLine("measure", "photos", 60).after(40);
    assertEquals(
        "measure: 50 of 60 photos (83%), 1.0 photos/s, 0:00:10 left",
        resumed.plain(50, TEN_SECONDS));
    assertTrue(resumed.plain(40, TEN_SECONDS).endsWith("? left"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "70 | run ring  25% [======                   ] 200000 steps/s, 0:00:30 left",
        "50 | run ring  25% 200000 steps/s, 0:00:30 left",
        "40 | 25%, 200000 steps/s, 0:00:30 left",
        "30 | 25%, 0:00:30 left",
        "10 | 25%",
      })
  void narrowTerminalsKeepTheTimeLeftLongest(int width, String expected) {
    assertEquals(expected, line.bar(2_000_000, TEN_SECONDS, width));
  }

  @ParameterizedTest
  @ValueSource(longs = {0, 1, 4_000_001, 7_999_999, 8_000_000})
  void fitsWheneverThereIsRoomForThePercentage(long done) {
    for (int width = 4; width < 200; width++) {
      String bar = line.bar(done, TEN_SECONDS, width);
      assertTrue(bar.length() <= width, bar);
    }
  }

  @Test
  void nothingIsLeftAtTheEndAndNothingIsKnownAtTheStart() {
    assertTrue(line.plain(8_000_000, TEN_SECONDS).endsWith("(100%), 800000 steps/s, 0:00:00 left"));
    assertTrue(line.plain(0, TEN_SECONDS).endsWith("0.0 steps/s, ? left"));
  }
}
