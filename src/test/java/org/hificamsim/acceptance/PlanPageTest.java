package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.apache.pdfbox.Loader;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the output of {@code place}: the page in a browser, the PDF, and the floor plan. */
class PlanPageTest {
  @TempDir static Path folder;
  private static Path plan;

  @BeforeAll
  static void place() {
    plan = folder.resolve("plan");
    Cli cli =
        Cli.run(
            (Object[])
                ("place "
                        + Cli.scenario("corridor")
                        + " --cameras 3 --cells 24 --candidates every=4")
                    .concat(" --out " + plan)
                    .split(" "));
    assertEquals(0, cli.exit(), cli.err());
  }

  @Test
  void pageShowsTheTablesAtAllWidths() throws IOException {
    Browser browser = Browser.shared();
    browser.open(plan.resolve("index.html").toUri().toString());
    String text = browser.text("main");
    assertTrue(text.contains("% of the demand is met") && text.contains("by the fixed view"), text);
    assertTrue(
        text.contains("Cameras, and what if one fails") && text.contains("Seen by no camera"),
        text);
    assertEquals(3, browser.findAll("[aria-label^=Cameras] tbody tr").size());
    assertEquals(
        true, browser.run("return [...document.images].every(image => image.naturalWidth > 0)"));
    Accessibility.checkWidths(browser);
    browser.assertQuietConsole();
  }

  @Test
  void pdfIsA4AndFloorPlanNamesCameras() throws IOException {
    try (PDDocument pdf = Loader.loadPDF(plan.resolve("plan.pdf").toFile())) {
      assertTrue(pdf.getNumberOfPages() >= 2);
      assertEquals(595, pdf.getPage(1).getMediaBox().getWidth());
      assertEquals(842, pdf.getPage(1).getMediaBox().getHeight());
    }
    String svg = Files.readString(plan.resolve("plan.svg"), StandardCharsets.UTF_8);
    for (String name : new String[] {"P1", "P2", "P3", "as asked for"}) {
      assertTrue(svg.contains(">" + name), name);
    }
    String levels = Files.readString(plan.resolve("levels.svg"), StandardCharsets.UTF_8);
    for (String name : new String[] {"P1", "none", "outline", "scrutinise"}) {
      assertTrue(levels.contains(">" + name), name);
    }
    assertTrue(levels.contains(" (asked for)"));
  }
}
