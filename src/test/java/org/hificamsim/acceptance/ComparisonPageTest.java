package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.By;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.support.ui.Select;

/** Tests the page of a comparison in a browser. */
class ComparisonPageTest {
  private static final String ROWS = "section.card:first-of-type tbody tr";

  private static final String CORNER_OF_FIRST_PICTURE =
      """
const context = document.createElement('canvas').getContext('2d');
context.drawImage(document.querySelector('.pictures img'), 0, 0);
return context.getImageData(2, 2, 1, 1).data.join();
""";

  @TempDir static Path folder;
  private static Browser browser;
  private static Path out;

  @BeforeAll
  static void compareAndStart() {
    out = folder.resolve("compared");
    Cli cli =
        Cli.run(
            "compare",
            Cli.scenario("ring-random"),
            Cli.scenario("cluster-scripted"),
            "--policies",
            "zoom-out,epsilon-greedy",
            "--steps",
            120,
            "--repeat",
            4,
            "--out",
            out);
    assertEquals(0, cli.exit(), cli.err());
    browser = Browser.shared();
  }

  @Test
  void showsAllCasesForEachMetric() throws IOException {
    open();
    new Select(browser.find("select[aria-label=detection]")).selectByValue("all");
    browser.find("input[name=more-columns]").click();
    String text = browser.text("section.card");
    for (String metric : List.of("proportion_of_optimal", "performance", "covered_0")) {
      new Select(browser.find("select[aria-label=metric]")).selectByValue(metric);
      List<String> expected = new ArrayList<>();
      for (String row : Files.readAllLines(out.resolve("summary.csv"))) {
        String[] cells = row.split(",", -1);
        if (cells[3].equals(metric)) {
          expected.add(String.join(",", cells[5], cells[6], cells[7]));
          assertTrue(text.contains(cells[2]));
        }
      }
      List<String> shown = new ArrayList<>();
      for (WebElement row : browser.findAll(ROWS)) {
        shown.add(cell(row, "mean") + "," + cell(row, "low") + "," + cell(row, "high"));
      }
      assertFalse(expected.isEmpty());
      Collections.sort(expected);
      Collections.sort(shown);
      assertEquals(expected, shown);
    }
    WebElement mean = browser.find(ROWS + " td[data-column=mean]");
    assertEquals(
        100 * Double.parseDouble(mean.getDomAttribute("data-text")),
        Double.parseDouble(mean.getText().replace(" %", "")),
        0.005);
    browser.assertQuietConsole();
  }

  @Test
  void beginsWithBestPolicyFirstUnderLastDetection() {
    open();
    List<String> heads =
        browser.findAll(".sortable thead").get(0).findElements(By.tagName("button")).stream()
            .map(WebElement::getText)
            .map(head -> head.replaceAll(" .$", ""))
            .toList();
    assertEquals(List.of("scenario", "policy", "mean", "interval"), heads);
    List<Double> means = column("mean").subList(0, 3);
    assertTrue(means.get(0) >= means.get(1) && means.get(1) >= means.get(2), means.toString());
  }

  @Test
  void beginsWithBestScoreInWordsOfObjective() throws IOException {
    open();
    double best =
        Files.readAllLines(out.resolve("summary.csv")).stream()
            .map(row -> row.split(",", -1))
            .filter(row -> row[0].equals("ring-random") && row[3].equals("mean_score"))
            .filter(row -> !List.of("optimal", "best-fixed").contains(row[2]))
            .filter(row -> row[1].equals("hifi:orb-lin"))
            .mapToDouble(row -> Double.parseDouble(row[5]))
            .max()
            .orElseThrow();
    assertEquals(best, Double.parseDouble(browser.text(".answer b")), 0.005);
    assertTrue(
        browser
            .text(".answer")
            .contains("cameras on the target with the fewest (k_min), mean of 120 steps"),
        browser.text(".answer"));
  }

  @Test
  void judgesChoicesByLastDetection() throws IOException {
    open();
    List<String> rows = Files.readAllLines(out.resolve("choices.csv"));
    assertEquals(5, rows.size(), rows.toString());
    for (String row : rows.subList(1, 5)) {
      assertTrue(row.contains(",hifi:orb-lin,"), row);
    }
    String[] last = rows.get(2).split(",");
    assertEquals(last[3], last[7], "the judge achieves what it predicts");
    List<String> titles =
        browser.findAll("section.card h2").stream().map(WebElement::getText).toList();
    assertTrue(titles.contains("What each detection model’s choice of policy achieves"));
  }

  @Test
  void opensForResearchersAndRemembersPlanners() {
    open();
    assertEquals("Score over time", secondCard());
    new Select(browser.find("#reader")).selectByValue("planner");
    open();
    assertEquals("Pictures", secondCard());
    new Select(browser.find("#reader")).selectByValue("researcher");
    assertEquals("Score over time", secondCard());
    browser.run("localStorage.clear()"); // other pages have it, too
    browser.assertQuietConsole();
  }

  private static String secondCard() {
    return browser.findAll("section.card h2").get(1).getText();
  }

  @Test
  void sortsByClickAndKey() {
    open();
    WebElement head = browser.findAll(".sortable thead button").get(2);
    assertEquals("mean", head.getText().split(" ")[0]);
    head.click();
    List<Double> up = column("mean");
    List<Double> sorted = new ArrayList<>(up);
    Collections.sort(sorted);
    assertEquals(sorted, up);
    head.sendKeys(Keys.ENTER);
    Collections.reverse(sorted);
    assertEquals(sorted, column("mean"));
    assertEquals(
        "descending", browser.findAll(".sortable thead th").get(2).getDomAttribute("aria-sort"));
  }

  @Test
  void showsSingleScenario() {
    open();
    int rows = browser.findAll(ROWS).size();
    new Select(browser.find("select[aria-label=scenario]")).selectByVisibleText("ring-random");
    assertEquals(rows / 2, browser.findAll(ROWS).size());
  }

  @Test
  void isAccessible() {
    open();
    Accessibility.checkEverywhere(browser);
  }

  @Test
  void opensWithInformativeMetric() {
    Path blind = folder.resolve("blind");
    Cli cli =
        Cli.run(
            "compare",
            Cli.scenario("cluster-random"),
            "--policies",
            "zoom-out",
            "--steps",
            20,
            "--repeat",
            2,
            "--out",
            blind);
    assertEquals(0, cli.exit(), cli.err());
    browser.open(blind.resolve("report.html").toUri().toString());
    assertEquals("covered_k", browser.find("select[aria-label=metric]").getDomProperty("value"));
    assertTrue(browser.text("section.card .notice").startsWith("k_min is always 0"));
    open();
    assertEquals(
        "proportion_of_optimal", browser.find("select[aria-label=metric]").getDomProperty("value"));
    assertEquals(0, browser.findAll("section.card:first-of-type .notice").size());
  }

  @Test
  void drawsPicturesWithoutRequests() {
    open();
    browser.until("return [...document.images].every(i => i.complete && i.naturalWidth > 100)");
    assertEquals(5, browser.findAll("img").size());
    assertEquals(1, browser.findAll(".lines canvas").size());
    assertEquals(4, browser.findAll(".lines .u-legend .u-series").size());
    assertEquals(List.of(address()), browser.requests());
    browser.assertQuietConsole();
  }

  @Test
  void picturesFitIntoNarrowWindowAndOpenAlone() {
    browser.size(400, 1000);
    try {
      open();
      browser.until("return [...document.images].every(i => i.complete && i.clientWidth > 100)");
      for (WebElement figure : browser.findAll(".pictures figure")) {
        assertEquals(
            true,
            browser.run("return arguments[0].scrollWidth <= arguments[0].clientWidth", figure));
      }
      assertTrue(browser.find(".pictures figure a").getDomProperty("href").startsWith("blob:"));
    } finally {
      browser.size(1280, 1000);
    }
  }

  @Test
  void picturesKeepColoursOfPoliciesOnDarkPages() {
    browser.dark(true);
    try {
      open();
      browser.until("return [...document.images].every(i => i.complete && i.naturalWidth > 100)");
      assertEquals("none", browser.find(".pictures img").getCssValue("filter"));
      assertEquals("26,34,43,255", browser.run(CORNER_OF_FIRST_PICTURE));
    } finally {
      browser.dark(false);
    }
  }

  /** One scenario, a bound, colours that are dark, and one policy that reaches nearly all. */
  @Test
  void greyPaletteAndBoundAreReadOnDarkPage() {
    Path grey = folder.resolve("grey");
    Cli cli =
        Cli.run(
            "compare",
            Cli.scenario("ring-random"),
            "--policies",
            "zoom-out,zoom-in,random,sarsa",
            "--palette",
            "grey",
            "--yardsticks",
            "bound",
            "--steps",
            20,
            "--repeat",
            2,
            "--out",
            grey);
    assertEquals(0, cli.exit(), cli.err());
    browser.dark(true);
    try {
      browser.open(grey.resolve("report.html").toUri().toString());
      assertTrue(browser.text(".answer").matches(".*, at least [0-9.]+ % of what is possible.*"));
      Set<String> lines = new HashSet<>();
      for (WebElement piece :
          browser.findAll(".lines .u-legend .u-series:not(:first-child) .u-marker")) {
        String colour = piece.getCssValue("border-top-color");
        assertTrue(brightness(colour) > 95, colour);
        lines.add(colour + piece.getCssValue("border-top-style"));
      }
      assertEquals(4, lines.size(), lines.toString());
      for (WebElement bar : browser.findAll(".whisker rect")) {
        assertTrue(brightness(bar.getCssValue("fill")) > 95, bar.getCssValue("fill"));
      }
      WebElement settings = browser.find(".card:has(.setting)");
      assertTrue(settings.getText().contains("zoom-out, zoom-in, random, sarsa"));
      assertTrue(settings.findElements(By.cssSelector("tbody tr")).size() <= 2, "by detection");
      browser.assertQuietConsole();
    } finally {
      browser.dark(false);
    }
  }

  private static int brightness(String colour) {
    return Integer.parseInt(colour.replaceFirst("rgba?\\((\\d+),.*", "$1"));
  }

  @Test
  void showsSharesAsPercentages() {
    Path shares = folder.resolve("shares");
    Cli cli =
        Cli.run(
            "compare",
            Cli.scenario("ring-random"),
            "--objective",
            "covered:k=1",
            "--detections",
            "camsim-range,hifi:orb-lin",
            "--policies",
            "zoom-out,zoom-in",
            "--steps",
            20,
            "--repeat",
            2,
            "--out",
            shares);
    assertEquals(0, cli.exit(), cli.err());
    browser.open(shares.resolve("report.html").toUri().toString());
    for (String column : List.of("predicted", "predicted_low", "achieved", "achieved_high")) {
      String text = browser.text("td[data-column=" + column + "]");
      assertTrue(text.endsWith(" %"), column + " is " + text);
    }
    assertRowsByScore(cli.out());
  }

  /** Asserts that the rows of one detection and scenario are sorted by score. */
  private static void assertRowsByScore(String table) {
    Map<String, Double> lastScores = new HashMap<>();
    Pattern row = Pattern.compile("(?m)^ring-random +(\\S+) +\\S+ +([0-9.]+) %");
    row.matcher(table)
        .results()
        .forEach(
            found -> {
              double score = Double.parseDouble(found.group(2));
              double last =
                  Objects.requireNonNullElse(lastScores.put(found.group(1), score), 100.0);
              assertTrue(score <= last, table);
            });
    assertEquals(2, lastScores.size(), table);
  }

  @Test
  void showsDifferentLegendEntryForEachCurve() {
    open();
    new Select(browser.find(".card:has(.lines) select[name=detection]")).selectByValue("all");
    Set<String> looks = new HashSet<>();
    List<WebElement> pieces =
        browser.findAll(".lines .u-legend .u-series:not(:first-child) .u-marker");
    for (WebElement piece : pieces) {
      looks.add(piece.getCssValue("border-top-color") + piece.getCssValue("border-top-style"));
    }
    assertEquals(6, pieces.size());
    assertEquals(pieces.size(), looks.size(), looks.toString());
  }

  @Test
  void showsRunsSettingsAndCommand() throws IOException {
    open();
    browser.find("details summary").click();
    browser.until("return document.querySelector('details tbody tr') !== null");
    List<String> results = Files.readAllLines(out.resolve("results.csv"));
    List<WebElement> rows = browser.findAll("details tbody tr");
    assertEquals(results.size() - 1, rows.size());
    assertEquals(results.get(1).split(",")[4], cell(rows.get(0), "performance"));
    assertTrue(browser.text("pre").startsWith("./hificamsim compare "));
    assertTrue(browser.text("main").contains("steps: 120"));
  }

  @Test
  void beginsReproductionWithStaticOptimum() {
    Path reproduced = ReproduceCommandTest.reproduced(1).folder();
    browser.open(reproduced.resolve("report.html").toUri().toString());
    assertTrue(
        browser
            .find("header + p.notice")
            .getText()
            .startsWith("The optimum is static: one zoom for all cameras, never changed, has its"));
    assertTrue(browser.find("header + p.notice").getText().contains("in 12 of 12 cases"));
  }

  @Test
  void beginsLadderWithLossPicturesAndRungs() throws IOException {
    Path ladder = folder.resolve("climbed");
    Cli cli =
        Cli.run(
            "ladder",
            Cli.scenario("ring-random"),
            "--rungs",
            "geometric,hifi:orb-lin",
            "--policies",
            "zoom-out,zoom-in",
            "--steps",
            20,
            "--repeat",
            2,
            "--out",
            ladder);
    assertEquals(0, cli.exit(), cli.err());
    browser.open(ladder.resolve("report.html").toUri().toString());
    assertTrue(browser.text("h1").startsWith("Ladder"));
    List<String> titles =
        browser.findAll("section.card h2").stream().map(WebElement::getText).limit(4).toList();
    assertEquals(
        List.of("The order of the policies by rung", "Pictures", "Side by side", "Score over time"),
        titles);
    assertEquals(
        List.of(
            "What is lost where each rung chooses the policy",
            "What each rung predicts of the policies"),
        browser.findAll("details summary").stream().map(WebElement::getText).limit(2).toList());
    double loss =
        Files.readAllLines(ladder.resolve("rungs.csv")).stream()
            .map(line -> line.split(",", -1))
            .filter(cells -> cells[0].equals("all") && cells[1].equals("geometric"))
            .mapToDouble(cells -> Double.parseDouble(cells[10]))
            .findFirst()
            .orElseThrow();
    assertEquals(
        100 * loss, Double.parseDouble(browser.text(".answer b").replace(" %", "")), 0.051);
    browser.until("return document.querySelectorAll('.pictures .wide').length > 0");
    browser.until("return document.querySelector('.lines canvas').clientWidth > 300");
    browser.assertQuietConsole();
  }

  private static void open() {
    browser.open(address());
  }

  private static String address() {
    return out.resolve("report.html").toUri().toString();
  }

  private static List<Double> column(String name) {
    return browser.findAll(ROWS).stream().map(row -> Double.valueOf(cell(row, name))).toList();
  }

  private static String cell(WebElement row, String column) {
    return row.findElement(By.cssSelector("[data-column=" + column + "]"))
        .getDomAttribute("data-text");
  }
}
