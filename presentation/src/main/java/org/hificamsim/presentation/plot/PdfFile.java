package org.hificamsim.presentation.plot;

import de.rototor.pdfbox.graphics2d.PdfBoxGraphics2D;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import java.util.Optional;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.pdmodel.PDPage;
import org.apache.pdfbox.pdmodel.PDPageContentStream;
import org.apache.pdfbox.pdmodel.common.PDRectangle;
import org.apache.pdfbox.util.Matrix;

/**
 * Writes a PDF document with a page for each picture. Letters of a single picture are outlines, so
 * that it looks like its other formats; those of a document of pages are text.
 */
final class PdfFile {
  private PdfFile() {}

  /**
   * Writes a picture as a document.
   *
   * @param width the width of the page, in points
   */
  static void write(OutputStream out, Paintable picture, double width) throws IOException {
    try (PDDocument document = new PDDocument()) {
      document.setDocumentId(0L); // the same bytes each time
      add(document, picture, (float) (width / picture.width()), Optional.empty());
      document.save(out);
    }
  }

  /** Writes pages as a document with text that can be searched. */
  static void write(OutputStream out, List<? extends Paintable> pages) throws IOException {
    try (PDDocument document = new PDDocument()) {
      document.setDocumentId(0L);
      Optional<EmbeddedText> text = Optional.of(new EmbeddedText(document));
      for (Paintable page : pages) {
        add(document, page, 1, text);
      }
      document.save(out);
    }
  }

  private static void add(
      PDDocument document, Paintable picture, float scale, Optional<EmbeddedText> text)
      throws IOException {
    PdfBoxGraphics2D graphics = new PdfBoxGraphics2D(document, picture.width(), picture.height());
    text.ifPresent(graphics::setFontTextDrawer);
    FigureFile.paint(picture, graphics);
    graphics.dispose();
    PDPage page = new PDPage(new PDRectangle(scale * picture.width(), scale * picture.height()));
    document.addPage(page);
    try (PDPageContentStream content = new PDPageContentStream(document, page)) {
      content.transform(Matrix.getScaleInstance(scale, scale));
      content.drawForm(graphics.getXFormObject());
    }
  }
}
