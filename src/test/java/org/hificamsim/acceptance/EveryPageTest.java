package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests the page of a run of each site, of two imports and of a random site, each with the settings
 * of its scenario. axe-core checks a few of them, and all, light and dark, with PAGES=all in the
 * environment.
 */
class EveryPageTest {
  private static final boolean CHECK_ALL = "all".equals(System.getenv("PAGES"));

  /**
   * The sites that axe-core always checks; they cover walls, a floor plan, turning cameras and an
   * objective other than the default.
   */
  private static final Set<String> SITES_CHECKED_BY_DEFAULT =
      Set.of("border", "mate-4v8-9", "museum", "street");

  private static final Pattern NUMBER = Pattern.compile("\\d+(\\.\\d+)?");

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
        "warehouse",
        "import of a table",
        "import of boxes",
        "generated"
      })
  void showsScoreOfSiteFirst(String site) throws IOException {
    Path out = folder.resolve(site.replace(' ', '-'));
    Cli cli = Cli.run("run", scenario(site), "--steps", 5, "--record", "--heatmap", "--out", out);
    assertEquals(0, cli.exit(), cli.err());
    assertTrue(cli.out().startsWith("score "), cli.out());
    browser.open(out.resolve("report.html").toUri().toString());
    String text = browser.text("main");
    assertFalse(text.contains("[object") || text.contains("covered_0"), text);
    assertEquals(
        firstNumber(cli.out().split(": ", 2)[1]), // after the objective's words
        firstNumber(text.substring(browser.text("h1").length())),
        0.0051);
    for (int width : new int[] {400, 1400}) {
      for (boolean dark : CHECK_ALL ? new boolean[] {true, false} : new boolean[] {width == 400}) {
        browser.dark(dark);
        Accessibility.assertNothingSticksOut(browser, width);
        if (CHECK_ALL || SITES_CHECKED_BY_DEFAULT.contains(site) && dark) {
          browser.size(width, 1000);
          Accessibility.check(browser);
        }
      }
    }
    browser.dark(false);
    browser.assertQuietConsole();
  }

  /** The first number of a text; shares are in percent on terminals and pages. */
  private static double firstNumber(String text) {
    Matcher number = NUMBER.matcher(text);
    assertTrue(number.find(), text);
    return Double.parseDouble(number.group());
  }

  private static Path scenario(String site) throws IOException {
    switch (site) {
      case "import of a table":
        return imported("people.txt", "%1$d 1 %2$.1f 4\n%1$d 2 6 %2$.1f\n", "ethucy", "--rate", 2);
      case "import of boxes":
        return imported(
            "boxes.txt", "%1$d,7,0,0,0,0,1,%2$.1f,3,0\n", "mot", "--rate", 2, "--unit", "m");
      case "generated":
        Path file = folder.resolve("generated.xml");
        Cli made = Cli.run("generate", file, "--cameras", 5, "--lenses", "--walls", 6, "--seed", 8);
        assertEquals(0, made.exit(), made.err());
        return file;
      default:
        return Cli.scenario(site);
    }
  }

  /** A recording of ten samples with a draft of cameras. */
  private static Path imported(String name, String line, String format, Object... more)
      throws IOException {
    StringBuilder lines = new StringBuilder();
    for (int frame = 1; frame <= 10; frame++) {
      lines.append(String.format(Locale.ROOT, line, frame, frame * 0.8));
    }
    Path recording = Files.writeString(folder.resolve(name), lines);
    Object[] words = {"import", recording, "--format", format, "--cameras", 2, "--out", folder};
    Cli cli = Cli.run(Stream.concat(Arrays.stream(words), Arrays.stream(more)).toArray());
    assertEquals(0, cli.exit(), cli.err());
    return folder.resolve(name.replace(".txt", ".xml"));
  }
}
