package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.apache.pdfbox.Loader;
import org.apache.pdfbox.cos.COSName;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.pdmodel.PDResources;
import org.apache.pdfbox.pdmodel.font.PDFont;
import org.apache.pdfbox.pdmodel.graphics.form.PDFormXObject;
import org.apache.pdfbox.text.PDFTextStripper;
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
                        + " --cameras 3 --cells 24 --candidates every=4 --title client=Museum")
                    .concat(" --out " + plan)
                    .split(" "));
    assertEquals(0, cli.exit(), cli.err());
  }

  @Test
  void showsTablesAtAllWidths() throws IOException {
    Browser browser = Browser.shared();
    browser.open(plan.resolve("index.html").toUri().toString());
    String text = browser.text("main");
    assertTrue(text.contains("% of the demand is met") && text.contains("by the fixed view"), text);
    assertTrue(
        text.contains("Cameras, and what if one fails") && text.contains("Not seen as asked"),
        text);
    assertEquals(3, browser.findAll("[aria-label^=Cameras] tbody tr").size());
    assertEquals(
        true, browser.run("return [...document.images].every(image => image.naturalWidth > 0)"));
    Accessibility.checkWidths(browser);
    browser.assertQuietConsole();
  }

  @Test
  void writesTablesOfPdfAsTextInEmbeddedFonts() throws IOException {
    try (PDDocument pdf = Loader.loadPDF(plan.resolve("plan.pdf").toFile())) {
      String text = new PDFTextStripper().getText(pdf);
      for (String row : Files.readAllLines(plan.resolve("cameras.csv")).subList(1, 4)) {
        assertTrue(text.contains(row.split(",")[6]), text);
      }
      for (String words : new String[] {"client: Museum", "To order", "price, EUR", "1:"}) {
        assertTrue(text.contains(words), text);
      }
      for (PDFont font : fonts(pdf.getPage(0).getResources())) {
        assertTrue(font.isEmbedded(), font.getName());
      }
      assertFalse(fonts(pdf.getPage(0).getResources()).isEmpty());
    }
  }

  private static List<PDFont> fonts(PDResources resources) throws IOException {
    List<PDFont> fonts = new ArrayList<>();
    for (COSName name : resources.getFontNames()) {
      fonts.add(resources.getFont(name));
    }
    for (COSName name : resources.getXObjectNames()) {
      if (resources.getXObject(name) instanceof PDFormXObject form) {
        fonts.addAll(fonts(form.getResources()));
      }
    }
    return fonts;
  }

  @Test
  void pricesOfOrderAddUpToPriceOfPlan() throws IOException {
    double total = 0;
    for (String row : Files.readAllLines(plan.resolve("order.csv"))) {
      String[] cells = row.split(",");
      total += cells[0].equals("camera") ? 0 : Double.parseDouble(cells[3]);
    }
    String summary = Files.readString(plan.resolve("summary.json"));
    assertEquals(new ObjectMapper().readTree(summary).path("price").asDouble(), total, 1e-9);
  }

  @Test
  void pdfIsA4AndFloorPlanNamesCameras() throws IOException {
    try (PDDocument pdf = Loader.loadPDF(plan.resolve("plan.pdf").toFile())) {
      assertEquals(2, pdf.getNumberOfPages());
      assertEquals(595, pdf.getPage(1).getMediaBox().getWidth());
      assertEquals(842, pdf.getPage(1).getMediaBox().getHeight());
    }
    String svg = Files.readString(plan.resolve("plan.svg"), StandardCharsets.UTF_8);
    for (String name :
        new String[] {"P1", "P2", "P3", "as asked for", "not asked for", "blind zone"}) {
      assertTrue(svg.contains(">" + name), name);
    }
    String levels = Files.readString(plan.resolve("levels.svg"), StandardCharsets.UTF_8);
    for (String name : new String[] {"P1", "none", "outline", "scrutinise"}) {
      assertTrue(levels.contains(">" + name), name);
    }
    assertTrue(levels.contains(" (asked for)"));
  }
}
