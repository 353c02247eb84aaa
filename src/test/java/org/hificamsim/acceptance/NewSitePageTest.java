package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.WebElement;

/** Tests {@code view --new}, where a site begins with a floor plan. */
class NewSitePageTest {
  private static final String SETUP = "return hificamsim.runs[0].setup.";

  private static Browser browser;

  @TempDir private Path folder;
  private ViewProcess view;

  @BeforeAll
  static void start() {
    browser = Browser.shared();
  }

  @AfterEach
  void close() {
    browser.assertQuietConsole();
    browser.leave();
    view.close();
  }

  @Test
  void drawsSiteOnPicturePlansAndSavesIt() throws Exception {
    Path picture = Files.copy(Cli.ROOT.resolve("docs/img/shop.png"), folder.resolve("floor.png"));
    Path catalogue =
        Files.writeString(
            folder.resolve("own.csv"), "name,resolution,hfov,price\nown-4mp,2560,30-105,410\n");
    open(picture, "--catalogue", catalogue);
    assertEquals("scale", browser.run("return hificamsim.draw.tool.name"), "comes first");
    press(2, 2);
    press(12, 2);
    browser.find(".drawing [name=metres]").sendKeys("5\n");
    browser.until(SETUP + "field.maxX < 11");
    assertEquals(10, number(SETUP + "field.maxX"), 0.2);
    browser.find("#undo").click();
    browser.until(SETUP + "field.maxX === 20");

    String fieldBox =
        "return JSON.stringify(document.querySelector('canvas.field').getBoundingClientRect())";
    Object boxBefore = browser.run(fieldBox);
    choose("shelf", Map.of());
    drag(5, 3.5, 5.8, 9.5);
    browser.until(SETUP + "obstacles?.length === 1");
    choose("pillar", Map.of());
    drag(9, 6, 9.3, 6);
    browser.until(SETUP + "obstacles.length === 2");
    choose("wall", Map.of());
    press(14, 11);
    press(17, 11);
    browser.until(SETUP + "obstacles.length === 3");
    choose("zone", Map.of("zone", "till", "level", "oodpcvs-2025:level=perceive", "facing", "180"));
    drag(13.5, 2.2, 17.5, 3.5);
    browser.until("return hificamsim.zones?.[0]?.name === 'till'");
    choose("camera", Map.of("kind", "own-4mp", "angle", "60"));
    drag(15.5, 0.3, 15.5, 3);
    browser.until("return hificamsim.zones[0].met > 0");
    browser.find("#undo").click();
    browser.until(SETUP + "cameras.length === 0");

    browser.run(
        "hificamsim.draw.setDrawing(false); const {element, amount} = hificamsim.plan;"
            + "element.open = true; amount.value = 1");
    browser.find(".planning .plan").click();
    browser.until(SETUP + "cameras.length === 1 && hificamsim.zones[0].met > .5");
    browser.until("return document.querySelector('.planning .stop').hidden");
    assertTrue(browser.text(".planning .event").startsWith("1 camera, price 410.00"));
    assertEquals(boxBefore, browser.run(fieldBox), "stays while the legend and the lists grow");
    String isShown =
        "const {top, bottom} = document.querySelector('.planning .event').getBoundingClientRect();"
            + "return top >= 0 && bottom <= document.querySelector('.side')"
            + ".getBoundingClientRect().bottom";
    assertEquals(true, browser.run(isShown));
    browser.run(
        "const {height} = hificamsim.plan; height.value = 4; height.dispatchEvent(new"
            + " Event('change'))");
    for (int width : new int[] {400, 1400}) {
      browser.dark(width == 400);
      browser.size(width, 1000);
      Accessibility.check(browser);
      Accessibility.assertNothingSticksOut(browser, width);
    }
    browser.dark(false);

    Path saved = Files.writeString(folder.resolve("floor.xml"), saved());
    String xml = Files.readString(saved);
    assertTrue(xml.contains("mount_height=\"4.0\""), xml);
    assertTrue(xml.contains("height=\"1.8\"") && xml.contains("<pillar"), xml);
    assertTrue(xml.contains("floorplan=\"floor.png\"") && xml.contains("facing=\"180.0\""), xml);
    assertEquals(0, Cli.run("validate", saved).exit());
    Cli evaluated = Cli.run("place", "--evaluate", saved);
    Matcher share = Pattern.compile("zone till: ([0-9.]+) %").matcher(evaluated.out());
    assertTrue(share.find(), evaluated.out() + evaluated.err());
    double shown = 100 * number("return hificamsim.zones[0].met");
    assertEquals(shown, Double.parseDouble(share.group(1)), 0.01);
  }

  @Test
  void beginsWithWallsOfDrawing() {
    open(Cli.ROOT.resolve("examples/plans/room.dxf"));
    assertTrue(number(SETUP + "obstacles.length") > 3);
    assertEquals(16, number(SETUP + "field.maxX"));
    assertEquals("wall", browser.run("return hificamsim.draw.tool.name"), "it has a scale");
    choose("zone", Map.of("zone", "hall", "k", "0"));
    drag(2, 2, 5, 5);
    browser.until("return hificamsim.fault.textContent.startsWith('k is 0.0, expected')");
    browser.forgetConsole(); // Chromium logs the answer 400
  }

  @Test
  void fieldEndsWithPicture() throws IOException {
    Path picture = folder.resolve("long.png");
    ImageIO.write(new BufferedImage(400, 250, BufferedImage.TYPE_INT_RGB), "png", picture.toFile());
    open(picture);
    assertEquals(12.5, number(SETUP + "field.maxY"));
  }

  private void open(Path plan, Object... options) {
    view = new ViewProcess(Stream.concat(Stream.of("--new", plan), Stream.of(options)).toArray());
    browser.open(view.address());
    browser.until("return hificamsim.zones?.length > 0");
  }

  private static void choose(String tool, Map<String, String> values) {
    browser.run("const {draw} = hificamsim; draw.choice.value = arguments[0]; draw.choose()", tool);
    values.forEach(
        (name, value) ->
            browser.run(
                "document.querySelector(`.drawing [name=${arguments[0]}]`).value = arguments[1]",
                name,
                value));
  }

  private static void press(double x, double y) {
    WebElement field = browser.find("canvas.field");
    browser.actions().moveToElement(field, right(x, field), down(y, field)).click().perform();
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

  private static double number(String script) {
    return ((Number) browser.run(script)).doubleValue();
  }

  /** The scenario that the page saves. */
  private String saved() throws IOException, InterruptedException {
    HttpRequest request =
        HttpRequest.newBuilder(URI.create(view.address() + "scenario.xml")).build();
    HttpResponse<String> answer =
        HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofString());
    assertEquals(
        List.of("application/xml; charset=utf-8"), answer.headers().allValues("Content-Type"));
    return answer.body();
  }
}
