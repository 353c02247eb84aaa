package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.support.ui.Select;

/** Tests the page of a recorded run in a browser. */
class RunPageTest {
  private static final int STEPS = 200;
  private static final int SLOWEST_DRAWING =
      50; // milliseconds on average, ten times as long as a fast machine needs

  @TempDir static Path folder;
  private static Browser browser;
  private static Path run;

  @BeforeAll
  static void recordAndStart() {
    run = record("shown", Cli.scenario("cluster-scripted"), "--steps", STEPS, "--repeat", 3);
    browser = Browser.shared();
  }

  @Test
  void showsNumbersOfTables() throws IOException {
    open(run);
    String hidden = "return document.querySelector('[name=beliefs]').offsetParent === null";
    assertTrue((boolean) browser.run(hidden), "the policy has no beliefs to show");
    List<String> steps = Files.readAllLines(run.resolve("steps.csv"));
    for (int step : new int[] {0, 1, 57, 123, STEPS - 1}) {
      scrubTo(step);
      assertEquals(Integer.toString(step), browser.text("[data-name=step]"));
      String[] row = steps.get(1 + step).split(",");
      for (int column = 2; column < row.length; column++) {
        String name = steps.get(0).split(",")[column].replace("score", "k_min"); // the objective
        double shown = Double.parseDouble(browser.text(".readout [data-name=" + name + "]"));
        assertEquals(Double.parseDouble(row[column]), shown, 0.0005, name + " at step " + step);
      }
      assertPlayheadsAt(step / (STEPS - 1.0));
    }
    browser.assertQuietConsole();
  }

  @Test
  void namesEachFigureAndSettingOnce() {
    open(run);
    List<String> rows =
        browser.findAll(".details tbody th").stream().map(WebElement::getText).toList();
    assertEquals(rows.size(), Set.copyOf(rows).size(), rows.toString());
    assertTrue(rows.containsAll(List.of("mean score", "summed score", "zoom change rate")));
    assertFalse(rows.contains("performance") || rows.contains("steps from"), rows.toString());
    assertTrue(browser.text("[data-row=steps]").endsWith("(option)"));
  }

  @Test
  void describesTargetsAndCameras() throws IOException {
    open(run);
    List<String> targets = Files.readAllLines(run.resolve("targets.csv"));
    List<String> zooms = Files.readAllLines(run.resolve("zooms.csv"));
    for (int step : new int[] {0, 20, STEPS - 1}) {
      scrubTo(step);
      for (int i = 0; i < 3; i++) {
        String[] row = targets.get(1 + 3 * step + i).split(",");
        double x = Double.parseDouble(row[3]);
        double y = Double.parseDouble(row[4]);
        List<String> tooltip = hover(x, y).lines().toList();
        assertEquals("target " + row[2], tooltip.get(0));
        assertEquals(
            String.format(Locale.ROOT, "x %.3f m, y %.3f m", x, y).replace("-0.000", "0.000"),
            tooltip.get(1).replace("-0.000", "0.000"));
      }
      for (int camera : new int[] {0, 8, 13}) {
        String[] row = zooms.get(1 + 14 * step + camera).split(",");
        browser.findAll(".rows button").get(camera).click();
        assertEquals(row[2], browser.text(".agent h2"));
        WebElement now = browser.find(".agent tr.now");
        assertEquals(row[3], now.getDomAttribute("data-level"));
        assertTrue(browser.text(".agent .facts").contains("detects " + row[5] + " of 3"));
      }
    }
  }

  @Test
  void selectsClickedCamera() {
    open(run);
    point("pointerdown", 12.2, 6.0);
    assertEquals("Cam_01", browser.text(".agent h2"));
    assertTrue(hover(12.2, 6.0).startsWith("camera Cam_01\nx 12.200 m, y 6.000 m"));
    point("pointerdown", -1.0, -7.0);
    assertEquals("Cam_05", browser.text(".agent h2"));
    assertEquals("Cam_05", browser.text(".rows [aria-pressed=true]"));
  }

  @Test
  void keepsTooltipInsideField() {
    open(run);
    assertEquals(
        true,
        browser.run(
            """
const {field} = hificamsim.player, {width, height} = field.surface;
const box = field.element.getBoundingClientRect();
field.pointer.nearest = () => ({target: 0});
return [[1, 1], [width - 1, 1], [1, height - 1], [width - 1, height - 1]].every(corner => {
  field.pointer.position = corner;
  field.describe();
  const tip = field.tooltip.element.getBoundingClientRect();
  return tip.left >= box.left && tip.right <= box.right
      && tip.top >= box.top && tip.bottom <= box.bottom;
});
"""));
  }

  @Test
  void describesChartsUnderPointer() throws IOException {
    open(run);
    browser.run(
        "const over = document.querySelector('.u-over'), box = over.getBoundingClientRect();"
            + "over.dispatchEvent(new PointerEvent('pointermove', {clientX: box.right - 0.1}))");
    String last = Files.readAllLines(run.resolve("steps.csv")).get(STEPS).split(",")[2];
    assertEquals(
        "step %s: %s".formatted(STEPS - 1, last),
        browser.findAll(".chart .value").get(0).getText());
  }

  @Test
  void opensInMiddleOfRun() {
    browser.open(address(run));
    assertEquals(Integer.toString(STEPS / 2), browser.text("[data-name=step]"));
  }

  @Test
  void hidesZoomAndPolicyOfCamerasThatNeverMove() throws IOException {
    String scenario = Files.readString(Cli.scenario("ring-random"));
    Path still = folder.resolve("still.xml");
    Files.writeString(still, scenario.replaceAll("<zoom>.*?</zoom>", "<zoom>7.5</zoom>"));
    open(record("still", still, "--steps", 5));
    assertFalse(browser.find(".zooms").isDisplayed());
    assertEquals(0, browser.findAll("h1 small").size());
    open(run);
    assertTrue(browser.find(".zooms").isDisplayed());
  }

  @Test
  void opensAtStepInAddress() {
    browser.open(address(run) + "#120");
    assertEquals("120", browser.text("[data-name=step]"));
    assertPlayheadsAt(120 / (STEPS - 1.0));
  }

  @Test
  void playsToTheEndAndStops() {
    open(run);
    new Select(browser.find(".controls select")).selectByVisibleText("500 per s");
    browser.find(".controls .play").click();
    browser.until("return hificamsim.playhead.frame === " + (STEPS - 1));
    browser.until("return !hificamsim.playhead.playing");
    assertEquals(Integer.toString(STEPS - 1), browser.text("[data-name=step]"));
    browser.assertQuietConsole();
  }

  @Test
  void playsThinnedRunAtChosenSpeed() {
    open(run);
    assertEquals(
        2.5,
        browser.run(
            "const {playhead} = hificamsim;Object.assign(playhead, {every: 4, speed: 100, playing:"
                + " true, exact: 0, before: 0});playhead.tick(100); playhead.pause(); return"
                + " playhead.exact"));
  }

  @Test
  void playsByKeys() {
    open(run);
    browser.press(Keys.ARROW_RIGHT, Keys.ARROW_RIGHT);
    assertEquals("2", browser.text("[data-name=step]"));
    browser.press(Keys.ARROW_LEFT);
    assertEquals("1", browser.text("[data-name=step]"));
    browser.press(Keys.END);
    assertEquals(Integer.toString(STEPS - 1), browser.text("[data-name=step]"));
    browser.press(Keys.HOME);
    assertEquals("0", browser.text("[data-name=step]"));
    browser.press("+", "+");
    assertEquals(50L, browser.run("return hificamsim.playhead.speed"));
    browser.press(" ");
    browser.until("return hificamsim.playhead.frame > 3");
    browser.press(" ");
    assertEquals(false, browser.run("return hificamsim.playhead.playing"));
    for (WebElement control : browser.findAll("button, select, input, canvas[role=img]")) {
      boolean named = !control.isDisplayed() || !control.getAccessibleName().isBlank();
      assertTrue(named, control.getDomProperty("outerHTML"));
    }
  }

  @Test
  void isAccessible() {
    open(run);
    Accessibility.checkEverywhere(browser);
    Accessibility.assertNothingSticksOut(browser, 3840);
  }

  @Test
  void magnifiesAndMovesMap() {
    open(run);
    String across = "return hificamsim.player.field.map.x(1) - hificamsim.player.field.map.x(0)";
    double before = ((Number) browser.run(across)).doubleValue();
    browser.run(
        "hificamsim.player.field.surface.canvas.dispatchEvent(new WheelEvent('wheel',"
            + " {deltaY: -400, clientX: 300, clientY: 300}))");
    assertEquals(Math.E * before, ((Number) browser.run(across)).doubleValue(), 1e-6);
    browser.run("document.querySelector('canvas.field').focus()");
    String left = "return hificamsim.player.field.magnifier.left";
    double from = ((Number) browser.run(left)).doubleValue();
    browser.press(Keys.ARROW_RIGHT);
    assertTrue(((Number) browser.run(left)).doubleValue() < from);
    assertEquals("0", browser.text("[data-name=step]"), "the arrow was the map's");
    browser.press("0");
    assertEquals(before, ((Number) browser.run(across)).doubleValue(), 1e-9);
    browser.find(".lens button").click();
    assertEquals(1.5 * before, ((Number) browser.run(across)).doubleValue(), 1e-6);
  }

  @Test
  void remembersOrderForReader() {
    open(run);
    String first = "return document.querySelector('.parts').firstElementChild.className";
    assertEquals("single apart", browser.run(first));
    new Select(browser.find("#reader")).selectByValue("researcher");
    assertEquals("curves", browser.run(first));
    open(run);
    assertEquals("curves", browser.run(first));
    new Select(browser.find("#reader")).selectByValue("planner");
  }

  @Test
  void describesLens() throws IOException {
    Path seen = record("seen", Cli.scenario("ring-random"), "--steps", 5);
    ObjectMapper json = new ObjectMapper();
    ObjectNode summary = (ObjectNode) json.readTree(seen.resolve("summary.json").toFile());
    summary.put("mount_height", 2.5);
    ArrayNode lengths = summary.putArray("focal_lengths");
    DoubleStream.of(0.012, 0.008, 0.006, 0.0048, 0.004).forEach(lengths::add);
    json.writeValue(seen.resolve("summary.json").toFile(), summary);
    Cli report = Cli.run("report", seen);
    assertEquals(0, report.exit(), report.err());
    open(seen);
    String note = browser.text(".agent .note");
    assertTrue(note.contains("Focal length by level, from 0: 12, 8, 6, 4.8, 4 mm."), note);
    assertTrue(note.contains("Mounted 2.5 m over the targets."), note);
  }

  @Test
  void isAccessibleForSingleRun() {
    Path single = record("single", Cli.scenario("ring-random"), "--steps", 20);
    open(single);
    Accessibility.check(browser);
    Accessibility.assertNothingSticksOut(browser, 400);
  }

  @Test
  void explainsKMinOfZero() {
    Path blind = record("blind", Cli.scenario("ring-random"), "--steps", 20, "--policy", "fixed:0");
    open(blind);
    assertEquals("0", browser.run("return String(Math.max(...hificamsim.run.kMin))"));
    assertTrue(browser.text(".notice").startsWith("k_min is 0 at every step"));
    open(run);
    assertEquals(0, browser.findAll(".notice").size());
  }

  @Test
  void playsByKeysOnSlider() {
    open(run);
    browser.run("document.querySelector('input[type=range]').focus()");
    browser.press(Keys.ARROW_RIGHT);
    assertEquals("1", browser.text("[data-name=step]"));
    browser.press(" ");
    browser.until("return hificamsim.playhead.playing");
    browser.press(" ");
    assertEquals(false, browser.run("return hificamsim.playhead.playing"));
  }

  @Test
  void makesNoRequests() {
    open(run);
    browser.press(Keys.END);
    assertEquals(List.of(address(run)), browser.requests());
  }

  @Test
  void opensOtherRepeats() throws IOException {
    open(run);
    new Select(browser.find("#run")).selectByVisibleText("2 (seed 2)");
    browser.until("return document.getElementById('page').dataset.ready === '2'");
    scrubTo(50);
    String[] row = Files.readAllLines(run.resolve("steps.csv")).get(1 + 2 * STEPS + 50).split(",");
    assertEquals("2", row[0]);
    assertEquals(row[2], browser.text(".readout [data-name=k_min]"));
    assertEquals(
        Double.parseDouble(row[7]), Double.parseDouble(browser.text("[data-name=mean_k]")), 0.0005);
  }

  @ParameterizedTest
  @ValueSource(strings = {"sarsa", "zoom-out"})
  void showsEstimatesOfAgents(String policy) {
    Path recorded = record(policy, Cli.scenario("ring-random"), "--steps", 80, "--policy", policy);
    open(recorded);
    browser.press(Keys.END);
    boolean learns = policy.equals("sarsa");
    assertEquals(learns, browser.text(".agent thead").contains("Q"));
    assertEquals(!learns, browser.text(".agent .note").contains("keeps no estimates"));
    assertEquals(learns ? 5 : 0, browser.findAll(".agent [data-name=estimate]").size());
  }

  @Test
  void escapesNames() throws IOException {
    String name = "</script><img src=x onerror='window.fooled=1'>\"&amp;--><!--<script>";
    Path scenario =
        Files.writeString(
            folder.resolve("hostile.xml"),
            Files.readString(Cli.scenario("ring-random"))
                .replaceFirst(
                    "name=\"Cam_01\"",
                    "name=\""
                        + name.replace("&", "&amp;").replace("<", "&lt;").replace("\"", "&quot;")
                        + "\""));
    Path hostile = record("hostile", scenario, "--steps", 10);
    open(hostile);
    browser.findAll(".rows button").get(0).click();
    assertEquals(name, browser.text(".agent h2"));
    assertNull(browser.run("return window.fooled"));
    assertEquals(0, browser.findAll("img").size());
    browser.assertQuietConsole();
    assertEquals(List.of(address(hostile)), browser.requests());
  }

  @Test
  void showsTenThousandSteps() throws IOException {
    Path large = record("large", eightTargets(), "--steps", 10_000);
    Path page = large.resolve("report.html");
    assertTrue(Files.size(page) < 5_000_000, Files.size(page) + " bytes");
    open(large);
    assertEquals(10_000L, browser.run("return hificamsim.run.count"));
    browser.run("hificamsim.playhead.speed = 1000; hificamsim.playhead.play()");
    browser.until("return hificamsim.playhead.frame > 2500");
    browser.run("hificamsim.playhead.pause()");
    System.out.printf(
        "report of 10,000 steps x 14 cameras x 8 targets: %,d bytes, frames %s%n",
        Files.size(page), browser.run("return JSON.stringify(hificamsim.playhead.drawn)"));
    assertEquals(
        true,
        browser.run(
            "const {milliseconds, frames} = hificamsim.playhead.drawn;"
                + "return milliseconds / frames < arguments[0]",
            SLOWEST_DRAWING));
    browser.assertQuietConsole();
  }

  /** Writes the scenario of the cluster with eight targets. */
  private static Path eightTargets() throws IOException {
    String scenario = Files.readString(Cli.scenario("cluster-random"));
    List<String> added = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      added.add(
          "<object features=\"%s.0\" x=\"%s\" y=\"%s\" heading=\"%s\" speed=\"0.7\" size=\"0.66\"/>"
              .formatted(40 + i, 2 * i - 5, 3 - i, 70 * i));
    }
    return Files.writeString(
        folder.resolve("eight.xml"),
        scenario.replace("</objects>", String.join("\n", added) + "</objects>"));
  }

  private static Path record(String name, Path scenario, Object... options) {
    List<Object> words = new ArrayList<>(List.of("run", scenario, "--record"));
    words.addAll(List.of(options));
    Path out = folder.resolve(name);
    words.addAll(List.of("--out", out));
    Cli cli = Cli.run(words.toArray());
    assertEquals(0, cli.exit(), cli.err());
    return out;
  }

  private static String address(Path run) {
    return run.resolve("report.html").toUri().toString();
  }

  /** Opens the page of a run, and shows its first step. */
  private static void open(Path run) {
    browser.open(address(run));
    browser.run("hificamsim.playhead.show(0)");
  }

  private static void scrubTo(int step) {
    browser.run(
        "const s = document.querySelector('input[type=range]'); s.value = arguments[0];"
            + "s.dispatchEvent(new Event('input'))",
        step);
  }

  /** Asserts that the playheads of all three charts are at this share of the width. */
  private static void assertPlayheadsAt(double share) {
    browser.until(
        "const lines = [...document.querySelectorAll('.playhead')];"
            + "return lines.length === 3 && lines.every(line => line.style.transform)");
    List<?> places =
        (List<?>)
            browser.run(
                "return [...document.querySelectorAll('.playhead')].map(line =>"
                    + " new DOMMatrix(line.style.transform).e / line.parentElement.clientWidth)");
    assertEquals(3, places.size());
    places.forEach(place -> assertEquals(share, ((Number) place).doubleValue(), 0.005));
  }

  /** Moves the pointer to a position in the field, in metres, and returns the tooltip. */
  private static String hover(double x, double y) {
    point("pointermove", x, y);
    return (String) browser.run("return document.querySelector('.tip').textContent");
  }

  private static void point(String event, double x, double y) {
    browser.run(
        "const {map, surface: {canvas}} = hificamsim.player.field;"
            + "const box = canvas.getBoundingClientRect();"
            + "canvas.dispatchEvent(new PointerEvent(arguments[0], {bubbles: true,"
            + " clientX: box.left + map.x(arguments[1]), clientY: box.top + map.y(arguments[2])}))",
        event,
        x,
        y);
  }
}
