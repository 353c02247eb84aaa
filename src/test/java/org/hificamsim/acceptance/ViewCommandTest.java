package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InputStream;
import java.net.URI;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What {@code view} prints and refuses; the page has tests of its own. */
class ViewCommandTest {
  @Test
  void printsTheAddressInOneLineAndEndsWhenItsPageIsClosed() throws Exception {
    try (ViewProcess view = new ViewProcess(Cli.scenario("lattice-random"))) {
      assertTrue(
          view.address().matches("http://127\\.0\\.0\\.1:\\d+/[0-9a-f]{48}/"), view.address());
      try (InputStream events = URI.create(view.address() + "events").toURL().openStream()) {
        assertEquals('e', events.read()); // event: setup
      }
      assertEquals(0, view.exit(), view.err());
      assertEquals("", view.err());
    }
  }

  @Test
  void aPortInUseIsToldInOneLine() {
    try (ViewProcess view = new ViewProcess(Cli.scenario("lattice-random"))) {
      int port = URI.create(view.address()).getPort();
      Cli second = Cli.run("view", Cli.scenario("lattice-random"), "--port", port, "--no-browser");
      assertEquals(2, second.exit());
      assertEquals(1, second.err().lines().count(), second.err());
      assertTrue(second.err().startsWith("error: --port is " + port), second.err());
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--port 70000 | --port is 70000, expected a whole number from 0 to 65535",
        "--threshold 2 | threshold is 2.0, expected a number from 0 to 1",
        "--policy greedy | unknown policy 'greedy'",
        "--policy best-fixed | cannot be viewed live",
        "--policy fixed:9 | level of camera",
        "--detection nothing.json | nothing.json",
        "--seed x | 'x'",
      })
  void refusesWrongUsageInOneLine(String options, String expected) {
    Object[] words =
        Stream.concat(
                Stream.of("view", Cli.scenario("lattice-random"), "--no-browser"),
                Stream.of(options.strip().split(" ")))
            .toArray();
    Cli view = Cli.run(words);
    assertEquals(2, view.exit(), view.err());
    assertEquals(1, view.err().lines().count(), view.err());
    assertTrue(view.err().contains(expected), view.err());
    assertEquals("", view.out());
  }
}
