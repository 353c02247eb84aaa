package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.openqa.selenium.WebElement;

/** Tests the page of a study of strategies in a browser. */
class TradeoffPageTest {
  @TempDir static Path folder;
  private static Browser browser;
  private static Path out;

  @BeforeAll
  static void studyAndStart() {
    browser = Browser.shared();
    out = folder.resolve("study");
    List<Object> study =
        List.of("tradeoff", Cli.scenario("tutorial-camsim"), Cli.scenario("studies/yard"));
    Cli cli =
        Cli.run(
            study.get(0),
            study.get(1),
            study.get(2),
            "--heterogeneous",
            "sample:20",
            "--bandits",
            "UCB1",
            "--steps",
            60,
            "--repeat",
            3,
            "--out",
            out);
    assertEquals(0, cli.exit(), cli.err());
    cli = Cli.run("report", out, "--replays");
    assertEquals(0, cli.exit(), cli.err());
  }

  private static void open() {
    browser.open(out.resolve("report.html").toUri().toString());
  }

  @Test
  void drawsPointForEachNetwork() throws IOException {
    open();
    List<String> rows = Files.readAllLines(out.resolve("networks.csv"));
    assertEquals(rows.size() - 1, browser.findAll("svg circle[data-network]").size());
    Object outside =
        browser.run(
            """
return [...document.querySelectorAll('svg circle[data-network]')].filter(point => {
  const [box, plot] = [point.getBBox(), point.ownerSVGElement.viewBox.baseVal];
  return box.x < 0 || box.y < 0 || box.x + box.width > plot.width || box.y + box.height > plot.height;
}).length;
""");
    assertEquals(0L, outside);
    String text = browser.text("main");
    assertTrue(text.contains("Heterogeneous networks extend the front"), text);
    assertTrue(text.contains("Bandits come near the front"), text);
    browser.assertQuietConsole();
  }

  @Test
  void describesClickedNetworkAndLinksReplay() throws IOException {
    open();
    String front = Files.readAllLines(out.resolve("fronts.csv")).get(2).split(",")[11];
    for (String network : List.of(front.split(" ")[0], "A0")) {
      WebElement point =
          browser.find("svg circle[data-network='" + network + "']"); // of the first scenario
      browser.run("arguments[0].dispatchEvent(new MouseEvent('click', {bubbles: true}))", point);
      String description = browser.text("section.card:first-of-type [aria-live]");
      assertTrue(description.startsWith(network) && description.contains("utility"), description);
      assertTrue(description.contains(network.contains("-") ? "; " : "all cameras: "), description);
      assertTrue(description.contains("./hificamsim run "), description);
      List<WebElement> links = browser.findAll("section.card:first-of-type [aria-live] a");
      String page = "replay-tutorial-camsim-" + network + "/report.html";
      assertEquals(Files.exists(out.resolve(page)) ? 1 : 0, links.size());
      if (network.equals(front.split(" ")[0])) {
        assertEquals(out.resolve(page).toUri().toString(), links.get(0).getDomProperty("href"));
        browser.open(links.get(0).getDomProperty("href"));
        assertTrue(browser.text("main").contains("tutorial-camsim"));
        open();
      }
    }
    browser.assertQuietConsole();
  }

  @Test
  void beginsWithUtilityAndCostOfFront() {
    open();
    List<WebElement> answers = browser.findAll(".answer");
    assertEquals(2, answers.size(), "a sentence for each scenario");
    for (WebElement answer : answers) {
      String text = answer.getText();
      assertTrue(text.matches(".*: \\d+ of \\d+ networks (is|are) on the front.*"), text);
      assertTrue(text.matches(".* with \\S+ % of the utility for \\S+ % of the cost.*"), text);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {400, 1400})
  void namesOfFrontAreReadableAndDoNotOverlap(int width) {
    browser.size(width, 1000);
    open();
    Object faults =
        browser.run(
            """
const overlap = (a, b) =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
return [...document.querySelectorAll('svg.tradeoff')].flatMap(plot => {
  const frame = plot.getBoundingClientRect();
  const names = [...plot.querySelectorAll('.front-name')];
  const boxes = names.map(name => name.getBoundingClientRect());
  return names
    .filter((name, i) => {
      const box = boxes[i];
      const isOutside = box.left < frame.left || box.right > frame.right || box.top < frame.top;
      return isOutside || box.height < 9 || boxes.slice(0, i).some(other => overlap(box, other));
    })
    .map(name => name.textContent);
});
""");
    assertEquals(List.of(), faults);
    assertTrue(browser.findAll("svg .front-name").size() > 1);
    browser.size(1280, 1000);
  }

  @Test
  void isAccessible() {
    open();
    browser.run("document.querySelector('button').click()");
    Accessibility.checkEverywhere(browser);
    browser.size(1280, 1000);
  }
}
