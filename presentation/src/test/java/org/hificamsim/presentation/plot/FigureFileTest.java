package org.hificamsim.presentation.plot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.apache.pdfbox.Loader;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.rendering.PDFRenderer;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.parallel.Parallel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

class FigureFileTest {
  private static Figure figure() {
    Curve rising = Curve.of(new double[] {0, 1, 2, 3});
    Curve falling = Curve.of(new double[] {3, 2, 1, 0});
    XyPanel panel =
        new XyPanel("lines", "time (steps)", "k_min")
            .x(0, 3)
            .y(0, 3)
            .band(Curve.of(new double[] {0, 0.5, 1, 2}), rising, Palette.BLUE)
            .faint(falling, Palette.GREEN)
            .line(rising, Palette.BLUE)
            .dashed(falling, Palette.BLACK);
    StackPanel stack =
        new StackPanel("bars", "share", List.of("a", "b"))
            .layer(List.of(0.4, 0.2), Palette.BLUE)
            .layer(List.of(0.6, 0.8), Palette.YELLOW);
    return new Figure(
        "A figure",
        "a note",
        List.of(new LegendEntry("blue", Palette.BLUE, LegendEntry.Mark.LINE)),
        List.of(panel, stack),
        2,
        300,
        200);
  }

  @Test
  void pngHasTwoPixelsPerPoint() throws IOException {
    BufferedImage image = ImageIO.read(new ByteArrayInputStream(png()));
    assertEquals(FigureFile.SCALE * figure().width(), image.getWidth());
    assertEquals(FigureFile.SCALE * figure().height(), image.getHeight());
    int[] pixels =
        image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    assertTrue(IntStream.of(pixels).distinct().count() > 50);
    assertTrue(IntStream.of(pixels).anyMatch(pixel -> pixel == Palette.BLUE.getRGB()));
    assertTrue(IntStream.of(pixels).anyMatch(pixel -> pixel == Palette.YELLOW.getRGB()));
  }

  @Test
  void svgIsWellFormedAndHasNoDtd() throws Exception {
    DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
    factory.setFeature("http://apache.org/xml/features/disallow-doctype-decl", true);
    Document document = factory.newDocumentBuilder().parse(new ByteArrayInputStream(svg()));
    assertEquals("svg", document.getDocumentElement().getTagName());
    assertEquals(
        String.valueOf(figure().width()), document.getDocumentElement().getAttribute("width"));
    assertTrue(document.getElementsByTagName("path").getLength() > 2);
    assertTrue(document.getDocumentElement().getTextContent().contains("A figure"));
  }

  @Test
  void pdfLooksLikePng() throws IOException {
    BufferedImage png = ImageIO.read(new ByteArrayInputStream(png()));
    BufferedImage pdf = page(written("pdf"), 72 * FigureFile.SCALE);
    assertEquals(png.getWidth(), pdf.getWidth());
    assertEquals(png.getHeight(), pdf.getHeight());
    long difference = 0;
    for (int i = 0; i < png.getWidth() * png.getHeight(); i++) {
      int x = i % png.getWidth();
      int y = i / png.getWidth();
      difference +=
          Math.abs((png.getRGB(x, y) >> 8 & 255) - (pdf.getRGB(x, y) >> 8 & 255)); // greens
    }
    assertTrue(
        difference < 2L * png.getWidth() * png.getHeight(), "greens differ by " + difference);
  }

  private static BufferedImage page(byte[] pdf, int dotsPerInch) throws IOException {
    try (PDDocument document = Loader.loadPDF(pdf)) {
      assertEquals(1, document.getNumberOfPages());
      return new PDFRenderer(document).renderImageWithDPI(0, dotsPerInch);
    }
  }

  @Test
  void filesOfSameFigureHaveSameBytes() throws IOException {
    for (String format : FigureFile.FORMATS) {
      assertArrayEquals(written(format), written(format), format);
    }
  }

  @Test
  void filesDrawnBySeveralThreadsHaveSameBytes() throws IOException {
    List<Integer> seeds = IntStream.range(0, 12).boxed().toList();
    List<FigureFile.Drawn> drawn = Parallel.map(seeds, 4, FigureFileTest::drawn);
    for (int seed : seeds) {
      FigureFile.Drawn alone = drawn(seed);
      for (int i = 0; i < FigureFile.FORMATS.size(); i++) {
        assertArrayEquals(alone.files().get(i), drawn.get(seed).files().get(i), i + ", " + seed);
      }
    }
  }

  private static FigureFile.Drawn drawn(int seed) {
    double[] noise = new Random(seed).doubles(500).toArray();
    XyPanel panel =
        new XyPanel("noise", "x", "y").x(0, 500).y(0, 1).straight(Curve.of(noise), Palette.BLUE);
    return FigureFile.draw(
        new Figure("Noise " + seed, "", List.of(), List.of(panel), 1, 300, 200), Optional.empty());
  }

  @Test
  void figureOfOneColumnHasRowForEachPanel() {
    Figure wide = figure();
    Figure tall = new Figure(wide.title(), wide.note(), wide.legend(), wide.panels(), 1, 300, 200);
    assertEquals(wide.height() + 200, tall.height());
    assertEquals(wide.width() - 300, tall.width());
  }

  @Test
  void longNoteIsBrokenIntoLines() throws IOException {
    Figure figure = figure();
    String note = "Means over seeds with 95% bootstrap intervals; ".repeat(4).strip();
    Figure withNote =
        new Figure(
            figure.title(), note, figure.legend(), figure.panels().subList(0, 1), 1, 300, 200);
    assertTrue(withNote.noteLines().size() > 2, withNote.noteLines().toString());
    assertEquals(note, String.join(" ", withNote.noteLines()));
    for (String line : withNote.noteLines()) {
      assertTrue(Fonts.width(line, Fonts.TEXT) <= withNote.width() - 2 * Figure.MARGIN, line);
    }
    Figure noNote = new Figure(figure.title(), "", figure.legend(), withNote.panels(), 1, 300, 200);
    assertEquals(
        noNote.height() + withNote.noteLines().size() * Figure.NOTE_LINE, withNote.height());
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    FigureFile.write(out, "svg", withNote);
    String svg = out.toString(StandardCharsets.UTF_8);
    withNote.noteLines().forEach(line -> assertTrue(svg.contains(line), line));
  }

  @Test
  void textHasSameSizeInPrintAtAnyWidth(@TempDir Path folder) throws Exception {
    for (int millimetres : new int[] {88, 180}) {
      try (OutputFolder out = new OutputFolder(folder)) {
        FigureFile.draw(figure(), Optional.of(new PrintWidth(millimetres))).write(out, "a");
        out.commit(List.of());
      }
      Element root =
          DocumentBuilderFactory.newInstance()
              .newDocumentBuilder()
              .parse(folder.resolve("a.svg").toFile())
              .getDocumentElement();
      String[] box = root.getAttribute("viewBox").split(" ");
      double width = Double.parseDouble(box[2]);
      assertEquals(millimetres + "mm", root.getAttribute("width"));
      double height = Double.parseDouble(root.getAttribute("height").replace("mm", ""));
      assertEquals(millimetres / width, height / Double.parseDouble(box[3]), 1e-9);
      double points = millimetres / 25.4 * 72 / width;
      assertEquals(8, points * Fonts.TEXT.getSize(), 0.15);
      assertEquals(7, points * Fonts.TICKS.getSize(), 0.3);
      BufferedImage image = ImageIO.read(folder.resolve("a.png").toFile());
      assertEquals(Math.round(millimetres / 25.4 * 300), image.getWidth());
      assertEquals(millimetres > 100, image.getWidth() > image.getHeight());
      BufferedImage page = page(Files.readAllBytes(folder.resolve("a.pdf")), 254);
      assertEquals(10 * millimetres, page.getWidth(), 1);
      assertEquals(10 * height, page.getHeight(), 1);
    }
  }

  @Test
  void rejectsInvalidWidths() {
    for (String width : List.of("88", "88cm", "39mm", "401mm", "wide")) {
      InputException error = assertThrows(InputException.class, () -> PrintWidth.parse(width));
      assertTrue(error.getMessage().startsWith("figure_width is '" + width + "', expected "));
    }
    assertEquals(88, PrintWidth.parse("88mm").millimetres());
  }

  private static byte[] png() throws IOException {
    return written("png");
  }

  private static byte[] svg() throws IOException {
    return written("svg");
  }

  private static byte[] written(String format) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    FigureFile.write(out, format, figure());
    return out.toByteArray();
  }
}
