package org.hificamsim.presentation.plot;

import de.rototor.pdfbox.graphics2d.PdfBoxGraphics2D;
import java.io.IOException;
import java.io.OutputStream;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.pdmodel.PDPage;
import org.apache.pdfbox.pdmodel.PDPageContentStream;
import org.apache.pdfbox.pdmodel.common.PDRectangle;
import org.apache.pdfbox.util.Matrix;

/** A picture as a PDF document of one page. Letters are outlines, so that it needs no fonts. */
final class PdfFile {
  private PdfFile() {}

  /**
   * Writes the document.
   *
   * @param width of the page, points; the height follows
   */
  static void write(OutputStream out, Paintable picture, double width) throws IOException {
    float scale = (float) (width / picture.width());
    try (PDDocument document = new PDDocument()) {
      document.setDocumentId(0L); // the same bytes each time
      PdfBoxGraphics2D graphics = new PdfBoxGraphics2D(document, picture.width(), picture.height());
      FigureFile.paint(picture, graphics);
      graphics.dispose();
      PDPage page = new PDPage(new PDRectangle(scale * picture.width(), scale * picture.height()));
      document.addPage(page);
      try (PDPageContentStream content = new PDPageContentStream(document, page)) {
        content.transform(Matrix.getScaleInstance(scale, scale));
        content.drawForm(graphics.getXFormObject());
      }
      document.save(out);
    }
  }
}
