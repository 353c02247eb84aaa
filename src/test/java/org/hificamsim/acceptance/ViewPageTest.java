package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.hificamsim.presentation.view.Browsers;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.openqa.selenium.Dimension;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.support.ui.Select;

/** Tests the live view in a browser. */
class ViewPageTest {
  private static final List<Dimension> SIZES =
      List.of(
          new Dimension(400, 800),
          new Dimension(1280, 720),
          new Dimension(1280, 1000),
          new Dimension(3840, 2000));

  private static final String CURVES_ARE_VISIBLE =
      "return hificamsim.players.every(({timeline: {kMin}}) =>"
          + " kMin.element.getBoundingClientRect().bottom <= innerHeight)";

  private static final String SHARE =
      "parseFloat(document.querySelector('.shares .met').textContent)";

  @TempDir static Path folder;
  private static Browser browser;
  private ViewProcess view;

  @BeforeAll
  static void start() {
    browser = Browser.shared();
  }

  @BeforeEach
  void open() {
    view = new ViewProcess(Cli.scenario("cluster-random"), "--policy", "zoom-out");
    browser.open(view.address());
  }

  /** Asserts that the page made requests to its own server only, and that its console is empty. */
  @AfterEach
  void assertNoRequestsAndErrors() {
    browser.assertQuietConsole();
    List<String> requests =
        browser.requests().stream().filter(url -> !url.startsWith("file:")).toList();
    assertTrue(requests.stream().allMatch(url -> url.startsWith(view.address())), "" + requests);
    browser.leave();
    view.close();
  }

  @Test
  void runsPausesAndSteps() {
    browser.until("return hificamsim.runs[0].count > 5");
    pause();
    long count = number("hificamsim.runs[0].count");
    browser.press(Keys.ARROW_RIGHT);
    browser.until("return hificamsim.playhead.frame === " + count);
    assertEquals(count + 1, number("hificamsim.runs[0].count"));
    browser.press(Keys.ARROW_LEFT);
    assertEquals(count - 1, number("hificamsim.playhead.frame"));
    assertEquals(count + 1, number("hificamsim.runs[0].count"));
    browser.press(" ");
    browser.until("return hificamsim.runs[0].count > " + (count + 5));
    assertTrue((boolean) browser.run("return hificamsim.playhead.atEnd"));
  }

  @Test
  void runsAtChosenSpeed() {
    new Select(browser.find(".controls select")).selectByValue("1000");
    browser.until("return hificamsim.runs[0].steps > 1500");
    pause();
    long last = number("hificamsim.runs[0].steps");
    assertTrue(number("hificamsim.runs[0].count") > 100);
    assertEquals(last - 1, number("hificamsim.runs[0].step.at(-1)"));
  }

  @Test
  void keepsTargetsOnNewPolicyAndModel() {
    browser.until("return hificamsim.runs[0].count > 3");
    choose("policy", "sarsa");
    browser.until("return hificamsim.runs[0].setup.policy === 'sarsa'");
    long before = number("hificamsim.runs[0].count");
    browser.until("return hificamsim.runs[0].count > " + (before + 3));
    assertEquals(0, number("hificamsim.runs[0].step[0]"));
    assertTrue(browser.text(".agent table").contains("Q"));
    choose("detection", "geometric");
    browser.until("return hificamsim.runs[0].setup.detection === 'geometric'");
    choose("detection", "hifi:orb-lin");
    browser.until("return hificamsim.runs[0].setup.detection === 'hifi:orb-lin'");
    browser.find("[name=threshold]").sendKeys(Keys.chord(Keys.CONTROL, "a"), "0.2", Keys.ENTER);
    browser.until("return hificamsim.runs[0].setup.threshold === 0.2");
  }

  @Test
  void showsErrorOfInvalidChoice() {
    WebElement options = browser.find("[name=options]");
    options.sendKeys("speed=9", Keys.ENTER);
    browser.until("return !hificamsim.fault.hidden");
    assertTrue(browser.text("[role=alert]").contains("speed=9"), browser.text("[role=alert]"));
    assertEquals("zoom-out", browser.run("return hificamsim.runs[0].setup.policy"));
    assertEquals("speed=9", options.getDomProperty("value")); // the user is still typing
    new Select(browser.find("[name=policy]")).selectByValue("sarsa");
    browser.until("return hificamsim.runs[0].setup.policy === 'sarsa'");
    browser.run(
        "const {options, policy, element} = hificamsim.forms[0]; options.value = 'speed=9';"
            + "policy.value = 'random'; element.dispatchEvent(new Event('change'))");
    browser.until("return document.querySelector('[name=options]').value === ''");
    assertEquals("sarsa", browser.find("[name=policy]").getDomProperty("value"));
    assertTrue(browser.findAll("[name=policy] option[value=best-fixed]").isEmpty());
    browser.forgetConsole(); // Chromium logs the answer 400
  }

  @Test
  void movesDraggedCamera() {
    pause();
    String place =
        "const {map} = hificamsim.players[0].field, run = hificamsim.runs[0],"
            + " pose = run.pose(2, run.count - 1); return Math.round(";
    long x = (long) browser.run(place + "map.x(pose.x))");
    long y = (long) browser.run(place + "map.y(pose.y))");
    WebElement field = browser.find("canvas.field");
    browser
        .actions()
        .moveToElement(
            field,
            (int) x - field.getSize().getWidth() / 2,
            (int) y - field.getSize().getHeight() / 2)
        .clickAndHold()
        .moveByOffset(-40, 30)
        .moveByOffset(-20, 20)
        .release()
        .perform();
    browser.until("return !hificamsim.edits.sending");
    browser.press(Keys.ARROW_RIGHT);
    browser.until("return !hificamsim.runs[0].poses[2].at(-1).preview");
    assertEquals(x - 60.0, number(place, "map.x(pose.x))"), 1);
    assertEquals(y + 50.0, number(place, "map.y(pose.y))"), 1);
  }

  @Test
  void keepsClickedCameraInPlace() {
    pause();
    String drag =
        "const {field} = hificamsim.players[0], {map, surface: {canvas}} = field;"
            + "const run = hificamsim.runs[0], pose = run.pose(2, run.count - 1);"
            + "const box = canvas.getBoundingClientRect(), drags = [];"
            + "canvas.setPointerCapture = () => {}; field.pointer.handlers.drag = (camera, x, y) =>"
            + "  drags.push([camera, Math.round(map.x(x) - map.x(pose.x)),"
            + "    Math.round(map.y(y) - map.y(pose.y))].join(' '));"
            + "const fire = (name, right, down) => canvas.dispatchEvent(new PointerEvent(name, {"
            + "  button: arguments[0], clientX: box.left + map.x(pose.x) + 5 + right,"
            + "  clientY: box.top + map.y(pose.y) - 4 + down}));"
            + "fire('pointerdown', 0, 0); fire('pointermove', 2, 0); fire('pointermove', 12, 7);"
            + "fire('pointermove', 1, 1); fire('pointercancel', 1, 1); fire('pointermove', 9, 9);"
            + "return drags.join()";
    assertEquals("2 12 7,2 1 1", browser.run(drag, 0));
    assertEquals("", browser.run(drag, 2));
  }

  @Test
  void drawsPlayheadAtStep() {
    new Select(browser.find(".controls select")).selectByValue("100");
    browser.until("return hificamsim.runs[0].count > 100");
    pause();
    for (String chart : List.of("kMin", "cover")) {
      String script =
          "const {plot, line} = hificamsim.players[0].timeline.%s;"
              + "return Math.abs(plot.over.getBoundingClientRect().right"
              + " - line.getBoundingClientRect().right) <= 2";
      browser.until(script.formatted(chart));
    }
  }

  /** A field can end within a pixel, which has to be cleared as well. */
  @Test
  void clearsLastPixelsOfField() {
    pause();
    String surface = "hificamsim.players[0].field.surface";
    browser.run(surface + ".canvas.style.cssText = 'width: 400.6px; height: 300.6px'");
    browser.until("return Math.abs(" + surface + ".width - 400.6) < 0.1");
    assertEquals(
        true,
        browser.run(
            "const surface = "
                + surface
                + ", {canvas} = surface, context = canvas.getContext('2d');"
                + "const last = () => [...context.getImageData(canvas.width - 1, 0, 1, 300).data,"
                + "  ...context.getImageData(0, canvas.height - 1, 400, 1).data].join();"
                + "surface.draw(); const before = last();"
                + "context.resetTransform(); context.fillStyle = 'red';"
                + "context.fillRect(0, 0, 500, 500); surface.draw();"
                + "return last() === before"));
    browser.forgetConsole(); // Chromium warns of reading pixels
  }

  @Test
  void showsSameTargetsToTwoModels() {
    browser.find("#compare").click();
    browser.until("return hificamsim.runs.length === 2 && hificamsim.runs[1].count > 3");
    new Select(browser.findAll("[name=detection]").get(1)).selectByValue("geometric");
    browser.until("return hificamsim.runs[1].setup.detection === 'geometric'");
    new Select(browser.find(".controls select")).selectByValue("200");
    long count = number("hificamsim.runs[0].count");
    browser.until("return hificamsim.runs[0].count > " + (count + 100));
    pause();
    assertEquals(
        true,
        browser.run(
            "const [a, b] = hificamsim.runs;"
                + "return a.x.every((list, i) => list.every((x, j) => x === b.x[i][j]))"
                + " && a.step.every((step, i) => step === b.step[i])"));
    assertEquals(
        true,
        browser.run(
            "const [a, b] = hificamsim.runs;"
                + "return a.sum.reduce((s, k) => s + k) < b.sum.reduce((s, k) => s + k)"));
    assertEquals(2, browser.findAll("canvas.field").size());
    browser.find("#compare").click();
    browser.until("return hificamsim.runs.length === 1");
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2})
  void fitsTheWindow(int models) throws IOException {
    choose("policy", "sarsa");
    browser.until("return hificamsim.runs[0].setup.policy === 'sarsa'");
    if (models == 2) {
      browser.find("#compare").click();
      browser.until("return hificamsim.runs.length === 2 && hificamsim.runs[1].count > 3");
      new Select(browser.findAll("[name=detection]").get(1)).selectByValue("camsim-range");
      browser.until("return hificamsim.runs[1].setup.detection === 'camsim-range'");
    }
    restart(); // makes the same steps each time, because the documentation shows the picture
    step(600);
    browser.until("return !hificamsim.waiting");
    for (Dimension size : SIZES) {
      browser.size(size.getWidth(), size.getHeight());
      browser.run("return new Promise(done => setTimeout(done, 200))");
      Path pictures = Files.createDirectories(Path.of("build", "screenshots"));
      browser.screenshot(pictures.resolve("view-%s-%s.png".formatted(size.getWidth(), models)));
      assertEquals(
          true, browser.run("return document.documentElement.scrollWidth <= innerWidth"), "wide");
      if (size.getWidth() > 400) {
        browser.until(CURVES_ARE_VISIBLE);
      }
      Accessibility.check(browser);
      Accessibility.assertNothingSticksOut(browser, size.getWidth());
    }
  }

  @Test
  void movesAndTurnsCameraByKeys() {
    pause();
    browser.findAll(".rows button").get(2).click();
    double x = number("return ", "hificamsim.edits.pose(2).x");
    double y = number("return ", "hificamsim.edits.pose(2).y");
    browser.press("w", "a", "a", "W");
    browser.press("e", "E", "q");
    browser.until("return !hificamsim.edits.sending");
    browser.press(Keys.ARROW_RIGHT);
    browser.until("return !hificamsim.runs[0].poses[2].at(-1).preview");
    assertEquals(x - 0.6, number("return ", "hificamsim.edits.pose(2).x"), 1e-9);
    assertEquals(y + 3.3, number("return ", "hificamsim.edits.pose(2).y"), 1e-9);
    assertEquals(30, number("return ", "hificamsim.edits.pose(2).heading * 180 / Math.PI"), 1e-9);
    assertTrue(
        browser.find("[role=status]").getDomProperty("textContent").endsWith("heading 30 degrees"));
    browser.press(Keys.ARROW_LEFT); // arrows still step
    assertEquals(number("hificamsim.runs[0].count - 2"), number("hificamsim.playhead.frame"));
  }

  @Test
  void movesCameraByForm() {
    pause();
    browser.findAll(".rows button").get(4).click();
    type("x", "3.25");
    type("y", "-1");
    type("heading", "45");
    browser.until("return !hificamsim.edits.sending");
    browser.press(Keys.TAB); // the field would handle the arrows itself
    step(1);
    assertEquals(3.25, number("return ", "hificamsim.runs[0].poses[4].at(-1).pose.x"));
    assertEquals(-1, number("return ", "hificamsim.runs[0].poses[4].at(-1).pose.y"));
    assertEquals(45, number("return ", "hificamsim.edits.pose(4).heading * 180 / Math.PI"), 1e-9);
    type("x", "99");
    browser.until("return !hificamsim.edits.sending");
    step(1);
    assertEquals(
        15, number("return ", "hificamsim.edits.pose(4).x"), "as near as the field reaches");
  }

  @Test
  void suggestsCamerasAndUpdatesShares() {
    browser.leave();
    view.close();
    view = new ViewProcess(Cli.scenario("corridor"), "--policy", "zoom-out");
    browser.open(view.address());
    browser.until("return document.querySelector('.shares')?.textContent.includes('field')");
    pause();
    long cameras = number("hificamsim.runs[0].setup.cameras.length");
    double all = share();
    browser.find(".pose .remove-camera").click();
    browser.until("return hificamsim.runs[0].setup.cameras.length === " + (cameras - 1));
    untilShare("< " + all);
    double before = share();
    browser.find(".pose .suggest").click();
    browser.until("return hificamsim.runs[0].setup.cameras.length === " + cameras);
    untilShare("> " + before);
    double added = share();
    browser.run(
        "hificamsim.players[0].select(0); hificamsim.edits.move(0, 0.5, 0.5);"
            + " hificamsim.edits.turn(0, 225)");
    untilShare("< " + added);
    browser.until("return !hificamsim.edits.sending");
    double moved = share();
    browser.find(".pose .suggest-place").click();
    untilShare("> " + moved);
    double suggested = share();
    browser.find("#undo").click();
    untilShare("< " + suggested);
  }

  @Test
  void showsSiteWithoutTargets() {
    browser.leave();
    view.close();
    Path plan = Cli.ROOT.resolve("examples/plans/room.dxf");
    Path out = folder.resolve("empty");
    assertEquals(0, Cli.run("site", plan, "--people", 0, "--out", out).exit());
    view = new ViewProcess(out.resolve("room.xml"));
    browser.open(view.address());
    browser.until("return document.querySelector('.shares')?.textContent.includes('field')");
    assertEquals(4, number("return ", "hificamsim.runs[0].setup.cameras.length"));
    assertTrue(share() > 50, share() + " %");
  }

  /** Returns the first of the shares that the page shows, in percent. */
  private static double share() {
    return ((Number) browser.run("return " + SHARE)).doubleValue();
  }

  /** Waits until the first share fulfils a comparison; it changes a moment after the cameras. */
  private static void untilShare(String comparison) {
    browser.until("return " + SHARE + " " + comparison);
  }

  @Test
  void savesScenarioWithAddedCamera() throws IOException {
    pause();
    browser.findAll(".rows button").get(4).click();
    browser.find(".pose .add").click();
    browser.until("return hificamsim.runs[0].setup.cameras.length === 15");
    assertEquals("added-1", browser.text(".agent h2"));
    type("x", "1.5");
    browser.until("return !hificamsim.edits.sending");
    Path saved = folder.resolve("cluster-random-edited.xml");
    Files.deleteIfExists(saved);
    browser.downloadTo(folder);
    browser.find("#save").click();
    waitFor(saved);
    assertTrue(Files.readString(saved).contains("name=\"added-1\" x=\"1.5\""));
    Cli validate = Cli.run("validate", saved);
    assertEquals(0, validate.exit(), validate.err());
    Path out = folder.resolve("saved");
    Cli run = Cli.run("run", saved, "--steps", 20, "--out", out);
    assertEquals(0, run.exit(), run.err());
    assertTrue(Files.readString(out.resolve("summary.json")).contains("\"cameras\" : 15"));
  }

  @Test
  void removesAndRestoresCamerasAndTargets() {
    pause();
    long steps = number("hificamsim.runs[0].steps");
    browser.findAll(".rows button").get(4).click();
    browser.find(".remove-camera").click();
    browser.until("return hificamsim.runs[0].setup.cameras.length === 13");
    browser.find("#undo").click();
    browser.until("return hificamsim.runs[0].setup.cameras.length === 14");
    browser.press(Keys.chord(Keys.CONTROL, "y"));
    browser.until("return hificamsim.runs[0].setup.cameras.length === 13");
    browser.press(Keys.chord(Keys.CONTROL, "z"));
    browser.until("return hificamsim.runs[0].setup.cameras.length === 14");
    long targets = number("hificamsim.runs[0].setup.targets.length");
    browser.run("hificamsim.players[0].targets.choose(1)");
    browser.find(".remove-target").click();
    browser.until("return hificamsim.runs[0].setup.targets.length === " + (targets - 1));
    browser.until("return hificamsim.runs[0].steps === " + steps);
  }

  @Test
  void holdsLevelOfFixedCamera() {
    browser.findAll(".rows button").get(2).click();
    browser.find(".agent [data-level='0'] .hold").click();
    browser.until("return hificamsim.runs[0].level[2].at(-1) === 0");
    browser.until("return !document.querySelector('.agent .free').hidden");
    browser.find(".agent .free").click();
    browser.until("return hificamsim.runs[0].level[2].at(-1) !== 0");
  }

  @Test
  void messagesDoNotMoveField() {
    pause();
    String top = "return document.querySelector('canvas.field').getBoundingClientRect().top";
    Object before = browser.run(top);
    browser.run("hificamsim.showFault('something is wrong')");
    assertTrue(browser.find(".messages [role=alert]").isDisplayed());
    assertEquals(before, browser.run(top));
  }

  private static void type(String field, String value) {
    browser
        .find(".pose input[name=" + field + "]")
        .sendKeys(Keys.chord(Keys.CONTROL, "a"), value, Keys.TAB);
  }

  private static void waitFor(Path file) {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(20);
    while (!Files.exists(file) && System.nanoTime() < end) {
      Thread.onSpinWait();
    }
    assertTrue(Files.exists(file), file + " was not saved");
  }

  @Test
  void saysWhichStepsAreShown() {
    pause();
    step(9);
    assertTrue(!browser.find(".messages .notice:not([role])").isDisplayed());
    browser.run("hificamsim.runs[0].thin(); hificamsim.runs[0].thin(); hificamsim.refresh()");
    browser.until("return !hificamsim.waiting");
    String notice = browser.text(".messages .notice:not([role])");
    assertTrue(
        notice.matches("This run has \\d+ steps; the page shows one in 4 of the .*"), notice);
  }

  @Test
  void restartsWithOtherSeed() {
    pause();
    Object before = browser.run("return hificamsim.runs[0].x.map(list => list[0])");
    step(3);
    WebElement seed = browser.find("#seed");
    seed.clear();
    seed.sendKeys("7");
    browser.find("#restart").click();
    browser.until("return hificamsim.runs[0].setup.seed === 7 && hificamsim.runs[0].count === 1");
    step(30);
    Object after = browser.run("return hificamsim.runs[0].x.map(list => list.at(-1))");
    assertNotEquals(before, after);
  }

  @Test
  void opensPageByFileForBrowser() throws IOException {
    Path file = Files.writeString(folder.resolve("open.html"), Browsers.page(view.address()));
    browser.leave();
    browser.follow(file.toUri().toString());
    browser.until("return window.hificamsim?.runs[0]?.count > 3");
    assertEquals(view.address(), browser.run("return location.href"));
    assertEquals("", browser.run("return document.referrer"));
  }

  @Test
  void continuesAfterReload() throws Exception {
    new Select(browser.find(".controls select")).selectByValue("100");
    browser.until("return hificamsim.runs[0].count > 50");
    pause();
    long steps = number("hificamsim.runs[0].steps");
    browser.run("hificamsim.old = true; location.reload()");
    browser.until("return !window.hificamsim?.old && window.hificamsim?.runs[0]?.count > 50");
    assertEquals(steps, number("hificamsim.runs[0].steps"));
    assertEquals(0, number("hificamsim.runs[0].step[0]"));
  }

  @Test
  void endsWhenPageIsClosed() throws Exception {
    browser.leave();
    assertEquals(0, view.exit(), view.err());
  }

  private static void choose(String name, String value) {
    new Select(browser.find("[name=" + name + "]")).selectByValue(value);
  }

  /** Restarts the simulation, and pauses it after the first step. */
  private static void restart() {
    pause();
    browser.find("#restart").click();
    browser.until("return hificamsim.runs[0].steps === 1 && hificamsim.playhead.count === 1");
  }

  private static void step(int steps) {
    long next = number("hificamsim.runs[0].steps") + steps;
    browser.run("hificamsim.playhead.move(arguments[0])", steps);
    browser.until("return hificamsim.runs[0].steps === " + next);
  }

  /** Pauses, and waits until all earlier steps are drawn. */
  private static void pause() {
    browser.until("return hificamsim.playhead.playing");
    browser.run(
        "hificamsim.shown = null; hificamsim.showState = function (state) {"
            + "  this.shown = state; Object.getPrototypeOf(this).showState.call(this, state); }");
    browser.find(".controls .play").click();
    browser.until(
        "const {shown, runs, waiting} = hificamsim;"
            + "return shown && !shown.running && shown.next === runs[0].steps && !waiting");
  }

  private static double number(String before, String expression) {
    return ((Number) browser.run(before + expression)).doubleValue();
  }

  private static long number(String expression) {
    return ((Number) browser.run("return " + expression)).longValue();
  }
}
