package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;

/**
 * Tests a scenario with optics, obstacles and a floor plan on the page of a run and in the live
 * view.
 */
class SitePageTest {
  private static final Path ROOT = Path.of(System.getProperty("hificamsim.root", "."));

  /** The score is the share of targets that two cameras cover, the objective of the hall. */
  private static final String SCORE_IS_THAT_OF_THE_TARGETS =
      """
const [run] = hificamsim.runs, at = run.count - 1;
const share = (run.covered[2][at] + run.covered[3][at]) / run.targets[at];
return Math.abs(parseFloat(document.querySelector('.readout .score dd').textContent) - 100 * share) < 0.06;
""";

  @TempDir static Path folder;
  private static Browser browser;
  private static Path scenario;
  private static Path run;

  @BeforeAll
  static void recordAndStart() throws IOException {
    scenario =
        Files.copy(ROOT.resolve("src/test/resources/seen/hall.xml"), folder.resolve("hall.xml"));
    BufferedImage floor = new BufferedImage(60, 40, BufferedImage.TYPE_INT_RGB);
    floor.createGraphics().fillRect(0, 0, 60, 40);
    for (int i = 0; i < 60 * 40; i++) {
      floor.setRGB(i % 60, i / 60, 0xFFE0C0);
    }
    ImageIO.write(floor, "png", folder.resolve("floor.png").toFile());
    run = folder.resolve("run");
    Cli cli =
        Cli.run(
            "run",
            scenario,
            "--record",
            "--policy",
            "epsilon-greedy:epsilon=0.3",
            "--steps",
            120,
            "--out",
            run);
    assertEquals(0, cli.exit(), cli.err());
    browser = Browser.shared();
  }

  private static void open() {
    browser.open(run.resolve("report.html").toUri() + "#60");
  }

  @Test
  void describesObstaclesAndTheirShadows() {
    open();
    assertEquals("wall, solid", browser.run(FieldScripts.TOOLTIP, 10, 4));
    assertEquals("pillar, lets 10 % through", browser.run(FieldScripts.TOOLTIP, 6.3, 14.2));
    assertEquals("polygon, solid", browser.run(FieldScripts.TOOLTIP, 22.2, 5.2));
    assertEquals("", browser.run(FieldScripts.TOOLTIP, 28, 17));
    browser.assertQuietConsole();
    assertEquals(1, browser.requests().size());
    Object ground = browser.run(FieldScripts.COLOUR, 28.3, 17.3);
    assertNotEquals(
        ground, browser.run(FieldScripts.COLOUR, 11.3, 6.3), "the fixed camera detects here");
    assertNotEquals(
        browser.run(FieldScripts.COLOUR, 11.3, 6.3),
        browser.run(FieldScripts.COLOUR, 9.3, 7.8),
        "behind a wall");
    String legend = browser.text(".legend");
    assertTrue(legend.contains("obstacle") && legend.contains("lets 30 % through"), legend);
    assertTrue(legend.contains("moves, sees nothing"), legend);
  }

  @Test
  void showsSettingsOfOptics() {
    open();
    String settings = browser.text("section.details");
    assertTrue(
        settings.contains("optics dome law pinhole, pixels 1280, hfov 30 60 90, pan -45 0 45"),
        settings);
    assertFalse(settings.contains("[object"), settings);
  }

  @Test
  void showsViewsByLevelAndPan() throws IOException {
    open();
    browser.findAll(".rows button").get(0).click();
    assertEquals("ptz-west", browser.text(".agent h2"));
    assertEquals(25, browser.findAll(".views td").size());
    String[] row = Files.readAllLines(run.resolve("zooms.csv")).get(1 + 60 * 4).split(",");
    WebElement now = browser.find(".views td[aria-current=true]");
    int view = Integer.parseInt(now.getDomAttribute("data-view"));
    assertEquals(row[3], Integer.toString(view % 5), "the zoom level");
    assertTrue(now.getDomAttribute("title").startsWith("level "), now.getDomAttribute("title"));
    browser.findAll(".rows button").get(3).click();
    assertEquals(0, browser.findAll(".views td").size(), "a camera that cannot turn");
  }

  @Test
  void showsTurningCameraAsBlind() {
    open();
    browser.findAll(".rows button").get(0).click();
    browser.run(
        "const {run, playhead} = hificamsim;"
            + "playhead.show(run.seeing[0].findIndex((view, i) => view < 0 && run.online[0][i]))");
    assertTrue(browser.text(".agent .facts").contains("sees nothing"));
    assertEquals(1, browser.findAll(".views td.now.blind").size());
  }

  @Test
  void showsDensityZones() {
    open();
    browser.findAll(".rows button").get(2).click();
    String place = "const {field} = hificamsim.player, view = field.view(2);" + "return %s";
    String east = "view.x + 5 * Math.sin(view.heading)";
    String north = "view.y + 5 * Math.cos(view.heading)";
    Object x = browser.run(place.formatted(east));
    Object y = browser.run(place.formatted(north));
    Object before = browser.run(FieldScripts.COLOUR, x, y);
    assertEquals("", browser.run(FieldScripts.TOOLTIP, x, y));
    browser.find("[name=density-zones]").sendKeys(" ");
    assertNotEquals(before, browser.run(FieldScripts.COLOUR, x, y));
    double density = ((Number) browser.run(place.formatted("view.density / 5"))).doubleValue();
    String tooltip = (String) browser.run(FieldScripts.TOOLTIP, x, y);
    assertEquals(density, Double.parseDouble(tooltip.split(" ")[0]), 0.06);
    String zone = density >= 250 ? "characterise" : density >= 125 ? "perceive" : "discern";
    assertTrue(tooltip.endsWith("px/m: " + zone), tooltip);
    assertTrue(browser.text(".legend").contains("discern 80"));
  }

  @Test
  void fadesFloorPlanByKeys() {
    open();
    browser.until("return hificamsim.player.field.floor[0].image.complete");
    Object half = browser.run(FieldScripts.COLOUR, 28.3, 17.3);
    browser.run("document.querySelector('[name=floor]').focus()");
    browser.press(Keys.HOME);
    assertEquals("255,255,255,255", browser.run(FieldScripts.COLOUR, 28.3, 17.3));
    assertNotEquals(half, browser.run(FieldScripts.COLOUR, 28.3, 17.3));
    assertEquals("60", browser.text("[data-name=step]"));
  }

  @Test
  void isAccessibleAtAllWidths() throws IOException {
    open();
    browser.find("[name=density-zones]").sendKeys(" ");
    Accessibility.checkWidths(browser);
  }

  @Test
  void addsRemovesAndSavesWalls() throws Exception {
    try (ViewProcess view = new ViewProcess(scenario, "--policy", "zoom-out")) {
      browser.open(view.address());
      browser.find(".controls .play").click();
      browser.until("return !hificamsim.playhead.playing");
      browser.run("document.querySelector('.drawing').open = true");
      browser.find(".drawing .draw").click();
      drag(26, 18, 28, 16);
      browser.until("return hificamsim.runs[0].setup.obstacles.length === 6");
      assertEquals(26, end("x1"), 0.1);
      assertEquals(16, end("y2"), 0.1);
      type("x1", "25", "y1", "12.5", "x2", "28.5", "y2", "12.5");
      browser.find(".drawing [name=y2]").sendKeys(Keys.ENTER);
      browser.until("return hificamsim.runs[0].setup.obstacles.length === 7");
      browser.until( // the answer to the command may come after the step that it changed
          "return document.querySelector('[role=status]').textContent"
              + " === 'wall from (25, 12.5) to (28.5, 12.5) added'");
      assertEquals("y2", browser.run("return document.activeElement.name"), "keeps the focus");
      type("x1", "99", "y1", "1", "x2", "2", "y2", "2");
      browser.find(".drawing .add-drawn").click();
      browser.until("return !hificamsim.fault.hidden");
      assertTrue(browser.text("[role=alert]").contains("x is 99"), browser.text("[role=alert]"));
      browser.forgetConsole(); // Chromium logs the answer 400
      browser.find(".drawing [name=drawn]").sendKeys("polygon");
      browser.find(".drawing .remove").sendKeys(Keys.ENTER);
      browser.until("return hificamsim.runs[0].setup.obstacles.length === 6");
      browser.until( // the answer to the command may come after the step that it changed
          "return document.querySelector('[role=status]').textContent.startsWith('polygon,"
              + " solid')");
      assertSavedIsValid();
      Accessibility.checkWidths(browser);
      browser.assertQuietConsole();
      browser.leave();
    }
  }

  @Test
  void holdsViewUntilReleased() {
    try (ViewProcess view = new ViewProcess(scenario, "--policy", "zoom-out")) {
      browser.open(view.address());
      browser.findAll(".rows button").get(2).click();
      browser.find(".views td[data-view='3'] button").sendKeys(Keys.ENTER);
      browser.until("return hificamsim.runs[0].level[2].at(-1) === 3");
      assertEquals("camera dome-corner: held at level 0, 0°", status());
      browser.until("return !document.querySelector('.agent .free').hidden");
      browser.find(".agent .free").sendKeys(Keys.ENTER);
      browser.until("return hificamsim.runs[0].level[2].at(-1) !== 3");
      browser.until("return document.querySelector('.agent .free').hidden");
      browser.leave();
    }
  }

  @Test
  void showsScoreWhileCameraIsDragged() {
    try (ViewProcess view = new ViewProcess(Cli.scenario("hall"), "--policy", "zoom-out")) {
      browser.open(view.address());
      browser.until("return hificamsim.runs[0].count > 3");
      WebElement field = browser.find("canvas.field");
      String pose = "return hificamsim.runs[0].poses[0][0].pose.";
      double x = ((Number) browser.run(pose + "x")).doubleValue();
      double y = ((Number) browser.run(pose + "y")).doubleValue();
      browser
          .actions()
          .moveToElement(field, right(x, field), down(y, field))
          .clickAndHold()
          .moveByOffset(30, 0)
          .perform();
      browser.until(
          "const {poses, step} = hificamsim.runs[0], last = poses[0].at(-1);return"
              + " hificamsim.players[0].field.pointer.cameraDrag && last.step > 0 && !last.preview "
              + "   && step.at(-1) > last.step");
      browser.until(SCORE_IS_THAT_OF_THE_TARGETS);
      assertTrue(browser.text(".readout .k_min").contains("k_min"));
      browser.actions().release().perform();
      browser.leave();
    }
  }

  @Test
  void reportsMissingFloorPlanBeforeWriting() throws IOException {
    Path withoutPicture =
        Files.writeString(
            folder.resolve("other.xml"),
            Files.readString(scenario).replace("floor.png", "none.png"));
    Path out = folder.resolve("none");
    Cli cli = Cli.run("run", withoutPicture, "--record", "--steps", 5, "--out", out);
    assertEquals(2, cli.exit());
    assertTrue(cli.err().contains("floorplan is 'none.png', expected a PNG or JPEG"), cli.err());
    assertFalse(Files.exists(out));
    assertEquals(2, Cli.run("view", withoutPicture, "--no-browser").exit());
    Cli validate = Cli.run("validate", withoutPicture);
    assertTrue(
        validate.err().contains("warning: " + withoutPicture + ": floorplan is"), validate.err());
    assertEquals(0, Cli.run("run", withoutPicture, "--steps", 5, "--out", out).exit());
  }

  private static void drag(double x1, double y1, double x2, double y2) {
    WebElement field = browser.find("canvas.field");
    browser
        .actions()
        .moveToElement(field, right(x1, field), down(y1, field))
        .clickAndHold()
        .moveToElement(field, right(x2, field), down(y2, field))
        .release()
        .perform();
  }

  private static int right(double x, WebElement field) {
    return pixel("map.x", x) - field.getSize().getWidth() / 2;
  }

  private static int down(double y, WebElement field) {
    return pixel("map.y", y) - field.getSize().getHeight() / 2;
  }

  private static int pixel(String map, double metres) {
    String script = "return Math.round(hificamsim.players[0].field." + map + "(arguments[0]))";
    return ((Number) browser.run(script, metres)).intValue();
  }

  private static double end(String name) {
    String last = "return hificamsim.runs[0].setup.obstacles.at(-1).";
    return ((Number) browser.run(last + name)).doubleValue();
  }

  private static void type(String... namesAndValues) {
    for (int i = 0; i < namesAndValues.length; i += 2) {
      browser
          .find(".drawing [name=" + namesAndValues[i] + "]")
          .sendKeys(Keys.chord(Keys.CONTROL, "a"), namesAndValues[i + 1]);
    }
  }

  private static String status() {
    return (String) browser.run("return document.querySelector('[role=status]').textContent");
  }

  private static void assertSavedIsValid() throws IOException {
    String xml =
        (String)
            browser.run(
                "const asked = new XMLHttpRequest(); asked.open('GET', 'scenario.xml', false);"
                    + "asked.send(); return asked.responseText");
    Path saved = Files.writeString(folder.resolve("saved.xml"), xml);
    assertTrue(xml.contains("x1=\"25.0\" y1=\"12.5\" x2=\"28.5\" y2=\"12.5\""), xml);
    assertTrue(xml.contains("floorplan=\"floor.png\"") && !xml.contains("<polygon"), xml);
    Cli validate = Cli.run("validate", saved);
    assertEquals(0, validate.exit(), validate.err());
  }
}
