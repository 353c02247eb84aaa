package org.hificamsim.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Duration;
import org.hificamsim.runs.hints.OptimumTime.Forecast;
import org.junit.jupiter.api.Test;

class CompareCommandTest {
  @Test
  void forecastNamesTimesAndFasterYardstick() {
    assertEquals(
        "the optimum of hall takes up to 0.25 s a step, all optima up to 3:07 hours;"
            + " --yardsticks bound takes a small part of it",
        CompareCommand.sentence(new Forecast("hall", 0.25, Duration.ofMinutes(187))));
    assertEquals(
        "the optimum of hall takes up to 12 s a step, all optima up to 30:00 hours;"
            + " --yardsticks bound takes a small part of it",
        CompareCommand.sentence(new Forecast("hall", 12.3, Duration.ofHours(30))));
  }
}
