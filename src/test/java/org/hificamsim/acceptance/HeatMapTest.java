package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Zone;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.openqa.selenium.support.ui.Select;

/**
 * Tests the heat map of a hall with walls, a floor plan, and targets that come and go: the table,
 * the pictures, and the layer of both pages.
 */
class HeatMapTest {
  private static final int STEPS = 120;

  private static final String ZONES =
      "<zone name=\"west\" points=\"0,0 9,20\"/>"
          + "<zone name=\"corner\" shape=\"polygon\" points=\"12,2 28,2 20,15\" k=\"2\"/>"
          + "<zone name=\"way\" shape=\"polyline\" points=\"2,10 20,10\"/>"
          + "<zone name=\"all\" shape=\"field\" detection=\"geometric\"/>";

  @TempDir static Path folder;
  private static Browser browser;
  private static Path scenario;
  private static Path run;

  @BeforeAll
  static void recordAndStart() throws IOException {
    String hall = Files.readString(Cli.ROOT.resolve("src/test/resources/seen/hall.xml"));
    String comesAndGoes =
        "<events>"
            + "<event timestep=\"40\" participant=\"object\" event=\"add\" name=\"0.9\" x=\"2\""
            + " y=\"18\" heading=\"90\" speed=\"0.3\""
            + " fqName=\"Straight\"/>"
            + "<event timestep=\"80\" participant=\"object\" event=\"error\" name=\"0.9\"/>"
            + "</events>";
    scenario = folder.resolve("hall.xml");
    Files.writeString(
        scenario,
        hall.replace("</objects>", "</objects>" + comesAndGoes)
            .replace("<cameras>", "<zones>" + ZONES + "</zones><cameras>"));
    BufferedImage floor = new BufferedImage(60, 40, BufferedImage.TYPE_INT_RGB);
    floor.createGraphics().fillRect(0, 0, 60, 40);
    ImageIO.write(floor, "png", folder.resolve("floor.png").toFile());
    run = folder.resolve("run");
    recorded(run, "--record");
    browser = Browser.shared();
  }

  /** Runs two repeats with a heat map. */
  private static Cli recorded(Path out, Object... more) {
    Object[] words = {"run", scenario, "--heatmap", "--cells", 60, "--steps", STEPS, "--repeat", 2};
    Object[] rest = {"--policy", "epsilon-greedy:epsilon=0.3", "--out", out};
    return done(Stream.of(words, rest, more).flatMap(Arrays::stream).toArray());
  }

  private static Cli done(Object... words) {
    Cli cli = Cli.run(words);
    assertEquals(0, cli.exit(), cli.err());
    return cli;
  }

  private static List<String[]> table() throws IOException {
    return Files.readAllLines(run.resolve("heatmap.csv")).stream()
        .skip(1)
        .map(line -> line.split(",", -1))
        .toList();
  }

  @Test
  void tableHasRowsOfCellsAndAllVisits() throws IOException {
    List<String[]> rows = table();
    assertEquals(60 * 40, rows.size());
    long visits = rows.stream().mapToLong(row -> Long.parseLong(row[10])).sum();
    long targets = Files.readAllLines(run.resolve("targets.csv")).size() - 1L;
    assertEquals(targets, visits, "every target is in the field at every step");
    for (String[] row : rows) {
      assertEquals(row[6].isEmpty(), row[7].isEmpty());
      if (!row[6].isEmpty()) {
        double sum =
            Double.parseDouble(row[7]) + Double.parseDouble(row[8]) + Double.parseDouble(row[9]);
        assertEquals(1, sum, 1e-5);
      }
    }
    assertTrue(rows.stream().anyMatch(row -> row[6].isEmpty()), "in the pillar");
  }

  @Test
  void sameSeedGivesSameTable() throws IOException {
    Path again = folder.resolve("again");
    Cli cli = recorded(again);
    assertTrue(cli.out().contains("heat map of 60 x 40 cells: of area and steps"), cli.out());
    assertArrayEquals(
        Files.readAllBytes(run.resolve("heatmap.csv")),
        Files.readAllBytes(again.resolve("heatmap.csv")));
    done("run", scenario, "--steps", 5, "--out", again);
    assertFalse(Files.exists(again.resolve("heatmap.csv")), "of an earlier run");
  }

  @Test
  void pageShowsNumbersOfTheTable() throws IOException {
    open();
    choose("mean-k");
    String[] row = table().get(12 * 60 + 22); // of the cell of half a metre from (11, 6) on
    String tooltip = (String) browser.run(FieldScripts.TOOLTIP, 11.3, 6.3);
    assertTrue(tooltip.startsWith(rounded(row[6]) + " cameras on average, none in "), tooltip);
    assertEquals(
        "in an obstacle",
        browser
            .run(FieldScripts.TOOLTIP, 16.2, 9.2)
            .toString()
            .lines()
            .skip(1)
            .findFirst()
            .orElse(""));
    assertTrue(browser.text(".heat-key").contains("240 steps: of area and steps"));
    assertFalse(browser.text(".heat-key").contains("–"), browser.text(".heat-key"));
    choose("visits");
    assertTrue(browser.text(".heat-key").startsWith("1"), browser.text(".heat-key"));
    browser.assertQuietConsole();
    assertEquals(1, browser.requests().size());
    choose("");
    Object bare = browser.run(FieldScripts.COLOUR, 11.3, 6.3);
    choose("mean-k");
    assertNotEquals(bare, browser.run(FieldScripts.COLOUR, 11.3, 6.3));
    choose("");
    assertEquals(bare, browser.run(FieldScripts.COLOUR, 11.3, 6.3));
  }

  @Test
  void tracksAreAtVisitedPlacesOnly() throws IOException {
    open();
    String[] row =
        Files.readAllLines(run.resolve("targets.csv")).stream()
            .map(line -> line.split(","))
            .filter(
                cells -> cells[0].equals("0") && cells[1].equals("60") && cells[2].equals("0.9"))
            .findFirst()
            .orElseThrow();
    double x = Double.parseDouble(row[3]);
    double y = Double.parseDouble(row[4]);
    browser.run("hificamsim.playhead.show(119)");
    Object bare = browser.run(FieldScripts.COLOUR, x, y);
    browser.find("[name=tracks]").sendKeys(" ");
    assertNotEquals(
        bare, browser.run(FieldScripts.COLOUR, x, y), "it was here at step 60, and is gone");
    browser.find("[name=tracks]").sendKeys(" ");
    assertEquals(bare, browser.run(FieldScripts.COLOUR, x, y));
  }

  @Test
  void scaleEndsAtTargetsPresentAtOnce() throws IOException {
    StringBuilder events = new StringBuilder("<events>");
    for (int i = 0; i < 200; i++) {
      events.append(
          ("<event timestep=\"%1$s\" participant=\"object\" event=\"add\" name=\"%2$s\" x=\"2\""
                  + " y=\"18\" heading=\"90\" speed=\"0.3\" fqName=\"Straight\"/><event"
                  + " timestep=\"%3$s\" participant=\"object\" event=\"error\" name=\"%2$s\"/>")
              .formatted(i, 100 + i, i + 1));
    }
    String hall = Files.readString(scenario).replaceFirst("(?s)<events>.*</events>", "");
    Path passing = folder.resolve("passing.xml");
    Files.writeString(passing, hall.replace("</objects>", "</objects>" + events + "</events>"));
    Path out = folder.resolve("passing");
    done("run", passing, "--record", "--steps", 150, "--out", out);
    browser.open(out.resolve("report.html").toUri() + "#100");
    assertEquals(205L, browser.run("return hificamsim.run.setup.targets.length"));
    assertEquals(6L, browser.run("return hificamsim.run.mostTargets"));
    assertEquals(
        true,
        browser.run("const {field} = hificamsim.player; return field.size === field.surface.unit"));
  }

  @Test
  void pageShowsCoverageOfZones() throws IOException {
    open();
    List<Zone> zones = ScenarioReader.read(scenario, name -> true, warning -> {}).zones();
    for (Zone zone : zones.subList(0, 2)) { // a line is as wide as a cell there
      List<String[]> cells =
          table().stream()
              .filter(row -> !row[7].isEmpty() && zone.contains(number(row[2]), number(row[3])))
              .toList();
      double covered =
          cells.stream().mapToDouble(row -> 1 - number(row[7])).average().orElseThrow();
      String shown = browser.text("[data-row=" + zone.name() + "] td:nth-child(4)");
      assertEquals(100 * covered, number(shown.replace(" %", "")), 0.051, zone.name());
    }
    assertEquals(4, browser.findAll(".zones tbody tr").size());
    assertTrue(browser.text("[data-row=corner]").contains("2 cameras"));
    assertTrue(browser.text(".zones .note").contains("as place and view count it"));
  }

  @Test
  void pageShowsShareOfZonesThatIsMet() throws IOException {
    open();
    JsonNode zones =
        new ObjectMapper().readTree(run.resolve("summary.json").toFile()).path("zones");
    assertEquals(4, zones.size());
    for (JsonNode zone : zones) {
      String name = zone.path("name").asText();
      String shown = browser.text("[data-row=" + name + "] td:nth-child(3)").replace(" %", "");
      assertEquals(100 * zone.path("met").asDouble(), number(shown), 0.051, name);
    }
  }

  private static double number(String text) {
    return Double.parseDouble(text);
  }

  @Test
  void pageIsReadableAtAllWidths() throws IOException {
    open();
    choose("mean-k");
    browser.find("[name=tracks]").sendKeys(" ");
    Accessibility.checkWidths(browser);
  }

  @Test
  void livePageComputesMapOnlyWhileShown() throws Exception {
    try (ViewProcess view = new ViewProcess(scenario, "--policy", "zoom-out")) {
      browser.open(view.address());
      browser.until("return hificamsim.playhead.playing && hificamsim.playhead.count > 5");
      assertEquals(false, browser.run("return Boolean(hificamsim.players[0].field.heat.heat)"));
      choose("mean-k");
      browser.until("return Boolean(hificamsim.players[0].field.heat.shown)");
      String legend = browser.text(".heat-key");
      assertTrue(legend.matches("(?s).*\\d steps? from \\d+ on: .*"), legend);
      browser.until(
          "return hificamsim.players[0].field.heat.heat.steps > arguments[0]"
              .replace("arguments[0]", "3"));
      Accessibility.checkWidths(browser);
      browser.run("hificamsim.send({command: 'drag', camera: 3, x: 20, y: 2})");
      browser.until("return hificamsim.players[0].field.heat.heat.first > 20");
      browser.find("#compare").click();
      browser.until("return Boolean(hificamsim.players[1]?.field.heat.shown)");
      choose("");
      browser.until("return hificamsim.heated === false");
      browser.assertQuietConsole();
      browser.leave();
    }
  }

  @Test
  void mapIsDrawnWithoutBrowser() throws IOException {
    Path png = folder.resolve("map.png");
    Path svg = folder.resolve("map.svg");
    done("report", run, "--heatmap", "covered-k", "--tracks", "--png", png, "--svg", svg);
    byte[] first = Files.readAllBytes(png);
    assertEquals(1600, ImageIO.read(png.toFile()).getWidth());
    String text = Files.readString(svg);
    assertTrue(text.contains("heat map of 2 runs of 120 steps"), "heading");
    assertTrue(text.contains("steps with 2 or more cameras"), "legend");
    done("report", run, "--heatmap", "covered-k", "--tracks", "--png", png, "--force");
    assertArrayEquals(first, Files.readAllBytes(png));
    done("report", run, "--heatmap", "covered-k", "--png", png, "--force");
    assertFalse(Arrays.equals(first, Files.readAllBytes(png)), "without tracks");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "report RUN --png FILE --heatmap hot | --heatmap is 'hot', expected one of mean-k,"
            + " covered,",
        "report RUN --png FILE --heatmap visits --step 3 | --heatmap shows all steps",
        "report RUN --gif FILE --heatmap visits | --heatmap needs --png, --svg or --pdf",
        "run SCENARIO --out FILE --cells 20 | --cells needs --heatmap",
        "run SCENARIO --out FILE --heatmap --cells 0 | --cells is 0, expected a whole number from 1"
            + " to 200",
        "run SCENARIO --out FILE --heatmap --cells 201 | --cells is 201, expected",
      })
  void rejectsInvalidOptionsInOneLine(String words, String expected) {
    Path file = folder.resolve("refused");
    Map<String, Object> paths = Map.of("RUN", run, "FILE", file, "SCENARIO", scenario);
    Cli cli =
        Cli.run(
            Stream.of(words.strip().split(" "))
                .map(word -> paths.getOrDefault(word, word))
                .toArray());
    cli.assertRejected(expected, file);
  }

  @Test
  void rejectsFolderWithoutMap() throws IOException {
    Path other = folder.resolve("other");
    done("run", Cli.scenario("ring-random"), "--record", "--steps", 5, "--out", other);
    Cli cli = Cli.run("report", other, "--png", folder.resolve("x.png"), "--heatmap", "visits");
    cli.assertRejected("run --record --heatmap", folder.resolve("x.png"));
    Files.copy(run.resolve("heatmap.csv"), other.resolve("heatmap.csv"));
    Cli foreign = Cli.run("report", other, "--out", folder.resolve("x.html"));
    foreign.assertRejected("heatmap.csv:2:5: x is 0.25, expected", folder.resolve("x.html"));
  }

  private static void open() {
    browser.open(run.resolve("report.html").toUri() + "#60");
  }

  private static void choose(String figure) {
    new Select(browser.find("[name=heat]")).selectByValue(figure);
  }

  private static String rounded(String number) {
    String text = String.format(Locale.ROOT, "%.2f", Double.parseDouble(number));
    return text.contains(".") ? text.replaceFirst("0+$", "").replaceFirst("\\.$", "") : text;
  }
}
