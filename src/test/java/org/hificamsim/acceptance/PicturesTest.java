package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests {@code report --png}, {@code --svg} and {@code --gif}. */
class PicturesTest {
  @TempDir static Path run;

  @TempDir Path folder;

  @BeforeAll
  static void record() {
    Cli.run(
        "run",
        Cli.scenario("cluster-random"),
        "--steps",
        60,
        "--record",
        "--repeat",
        2,
        "--out",
        run);
  }

  @Test
  void writesSameBytesForSameStep() throws IOException {
    List<String> formats = List.of("png", "svg", "pdf", "gif");
    for (int i = 0; i < 2; i++) {
      List<Object> words = new ArrayList<>(List.of("report", run));
      for (String format : formats) {
        words.addAll(List.of("--" + format, folder.resolve(i + "." + format)));
      }
      words.addAll(List.of("--step", 30, "--every", 20, "--width", 300));
      Cli report = Cli.run(words.toArray());
      assertEquals(0, report.exit(), report.err());
      assertTrue(report.out().contains("4 pictures, one for 20 steps"), report.out());
    }
    for (String format : formats) {
      assertArrayEquals(
          Files.readAllBytes(folder.resolve("0." + format)),
          Files.readAllBytes(folder.resolve("1." + format)),
          format);
    }
    assertEquals(300, ImageIO.read(folder.resolve("0.png").toFile()).getWidth());
    assertTrue(Files.readString(folder.resolve("0.svg")).contains("cluster-random, step 30 of 59"));
  }

  @Test
  void beginsWithScoreUnlessObjectiveIsKMin() throws IOException {
    Path site = folder.resolve("site");
    Path svg = folder.resolve("step.svg");
    Cli.run("run", Cli.scenario("museum"), "--steps", 4, "--record", "--heatmap", "--out", site);
    Cli.run("report", site, "--svg", svg, "--step", 2);
    List<String> rows = Files.readAllLines(site.resolve("steps.csv"));
    double score = Double.parseDouble(rows.get(3).substring(rows.get(3).lastIndexOf(',') + 1));
    String words = "targets covered by at least 2 cameras: ";
    String expected = words + String.format(Locale.ROOT, "%.1f %%", 100 * score);
    String text = Files.readString(svg);
    assertTrue(text.contains(expected), expected);
    Cli.run("report", site, "--svg", svg, "--heatmap", "covered", "--force");
    assertTrue(Files.readString(svg).contains(words), "the whole run's");
  }

  @Test
  void writesPageOnlyOnRequest() throws IOException {
    Files.deleteIfExists(run.resolve("report.html"));
    Path png = folder.resolve("last.png");
    Cli.run("report", run, "--png", png, "--run", 1);
    assertEquals(1600, ImageIO.read(png.toFile()).getWidth());
    assertFalse(Files.exists(run.resolve("report.html")));
    Path page = folder.resolve("page.html");
    Cli.run("report", run, "--png", png, "--force", "--out", page);
    assertTrue(Files.exists(page));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--png FILE --step 60 | --step is 60, expected a step from 0 to 59",
        "--png FILE --step -1 | --step is -1, expected a step from 0 to 59",
        "--png FILE --step x | 'x'",
        "--png FILE --run 2 | --run is 2, expected one of the 2 repeats recorded",
        "--gif FILE --from 30 --to 20 | --to is 20, expected a step from 30 on",
        "--gif FILE --every 0 | --every is 0, expected a multiple of 1, above 0",
        "--png FILE --width 5 | --width is 5, expected a whole number from 200 to 8000",
        "--gif FILE --per-second 0 | --per-second is 0, expected a whole number from 1 to 50",
      })
  void reportsInvalidNumbersInOneLine(String options, String expected) {
    Path file = folder.resolve("picture");
    Object[] words =
        Stream.concat(
                Stream.of("report", run),
                Stream.of(options.strip().split(" "))
                    .map(word -> word.equals("FILE") ? file : word))
            .toArray();
    Cli report = Cli.run(words);
    assertEquals(2, report.exit());
    assertEquals(1, report.err().lines().count(), report.err());
    assertTrue(report.err().contains(expected), report.err());
    assertFalse(Files.exists(file));
  }

  @Test
  void reportsMissingRecordingInOneLine() {
    Cli report = Cli.run("report", folder, "--png", folder.resolve("a.png"));
    assertEquals(2, report.exit());
    assertTrue(report.err().contains("'run' with --record"), report.err());
    assertEquals(1, report.err().lines().count());
  }
}
