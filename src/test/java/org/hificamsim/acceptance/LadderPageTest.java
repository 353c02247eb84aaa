package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.By;
import org.openqa.selenium.WebElement;

/** Tests the page of a ladder in a browser, and the warnings of the command. */
class LadderPageTest {
  @TempDir static Path folder;
  private static Browser browser;
  private static Path out;
  private static Cli ladder;

  @BeforeAll
  static void climbAndStart() {
    out = folder.resolve("ladder");
    ladder =
        Cli.run(
            "ladder",
            Cli.scenario("corridor"),
            "--rungs",
            "geometric,camsim-range,hifi:orb-pinhole,hifi:orb-power,hifi:orb-lin",
            "--policies",
            "zoom-out,random,zoom-in",
            "--steps",
            20,
            "--repeat",
            2,
            "--out",
            out);
    assertEquals(0, ladder.exit(), ladder.err());
    browser = Browser.shared();
  }

  @Test
  void warnsOfRungsBeyondTheirPhotos() {
    assertTrue(ladder.err().contains("'hifi:orb-lin' was not fitted on"), ladder.err());
    assertFalse(ladder.err().contains("'camsim-range' was not fitted on"), ladder.err());
  }

  @Test
  void showsOrderOfPoliciesAsHeatMap() throws IOException {
    open();
    List<WebElement> lines = browser.findAll(".ranks tbody tr");
    assertEquals(5, lines.size());
    List<String> expected = new ArrayList<>();
    for (String row : Files.readAllLines(out.resolve("ladder.csv"))) {
      String[] cells = row.split(",");
      if (cells[1].equals("hifi:orb-lin")) {
        expected.add(cells[6]);
      }
    }
    List<String> shown =
        lines.get(0).findElements(By.className("rank")).stream().map(WebElement::getText).toList();
    assertEquals(expected.stream().sorted().toList(), shown);
    assertEquals("ORB linear", lines.get(0).findElement(By.tagName("th")).getText());
  }

  @Test
  void drawsLinesOfOneRungAtOnce() {
    open();
    assertEquals(1 + 4, browser.findAll(".lines .u-legend tr").size());
  }

  @Test
  void isAccessible() {
    open();
    Accessibility.checkEverywhere(browser);
  }

  private static void open() {
    browser.open(out.resolve("report.html").toUri().toString());
  }
}
