package org.hificamsim.presentation.plot;

import de.rototor.pdfbox.graphics2d.PdfBoxGraphics2D;
import java.io.IOException;
import java.io.OutputStream;
import java.util.List;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.pdmodel.PDPage;
import org.apache.pdfbox.pdmodel.PDPageContentStream;
import org.apache.pdfbox.pdmodel.common.PDRectangle;
import org.apache.pdfbox.util.Matrix;

/**
 * Writes a PDF document with a page for each picture. Letters are outlines, so it needs no fonts.
 */
final class PdfFile {
  private PdfFile() {}

  /**
   * Writes the document.
   *
   * @param width of all pages, points
   */
  static void write(OutputStream out, List<? extends Paintable> pictures, double width)
      throws IOException {
    try (PDDocument document = new PDDocument()) {
      document.setDocumentId(0L); // the same bytes each time
      for (Paintable picture : pictures) {
        add(document, picture, (float) (width / picture.width()));
      }
      document.save(out);
    }
  }

  private static void add(PDDocument document, Paintable picture, float scale) throws IOException {
    PdfBoxGraphics2D graphics = new PdfBoxGraphics2D(document, picture.width(), picture.height());
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
