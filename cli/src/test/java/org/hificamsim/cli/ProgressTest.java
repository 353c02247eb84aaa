package org.hificamsim.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class ProgressTest {
  private long now;

  /** 36 of 60 photos were measured before; each of the others takes five seconds. */
  @Test
  void workDoneBeforeCountsAsDoneAndPromisesNoSpeed() {
    StringWriter told = new StringWriter();
    Progress progress =
        new Progress(
            "lab", " photos", 60, new PrintWriter(told, true), () -> TimeUnit.SECONDS.toNanos(now));
    now = 3;
    progress.resume(36);
    measure(progress, 2);
    measure(progress, 3);
    assertEquals(
        List.of(
            "lab: 38 of 60 photos (63%), 0.2 photos/s, 0:01:50 left",
            "lab: 41 of 60 photos (68%), 0.2 photos/s, 0:01:35 left"),
        told.toString().lines().toList());
  }

  private void measure(Progress progress, int photos) {
    for (int photo = 0; photo < photos; photo++) {
      now += 5;
      progress.advance();
    }
    progress.printLine();
  }
}
