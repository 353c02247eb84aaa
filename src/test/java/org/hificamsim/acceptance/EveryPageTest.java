package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The page of a run on each site, as a scenario without options asks for it. */
class EveryPageTest {
  /** With walls, a floor plan, turning cameras and a score of its own; the others repeat these. */
  private static final Set<String> CHECKED = Set.of("border", "mate-4v8-9", "museum", "street");

  @TempDir static Path folder;
  private static Browser browser;

  @BeforeAll
  static void start() {
    browser = Browser.shared();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "border",
        "campus",
        "car-park",
        "corridor",
        "hall",
        "hit-mac",
        "junction",
        "mate-4v8-9",
        "museum",
        "passage",
        "street",
        "warehouse"
      })
  void aSitesPageBeginsWithItsScoreAndHasNoFaults(String site) throws IOException {
    Path out = folder.resolve(site);
    Cli cli =
        Cli.run("run", Cli.scenario(site), "--steps", 5, "--record", "--heatmap", "--out", out);
    assertEquals(0, cli.exit(), cli.err());
    browser.dark(true);
    browser.size(400, 1000);
    browser.open(out.resolve("report.html").toUri().toString());
    String text = browser.text("main");
    assertFalse(text.contains("[object") || text.contains("covered_0"), text);
    double score =
        new ObjectMapper().readTree(out.resolve("summary.json").toFile()).path("score").asDouble();
    assertEquals(
        100 * score / 5, Double.parseDouble(browser.text(".answer b").replace(" %", "")), 0.051);
    if (CHECKED.contains(site)) {
      Accessibility.check(browser);
    }
    Accessibility.assertNothingSticksOut(browser, 400);
    browser.dark(false);
    browser.assertQuietConsole();
  }
}
