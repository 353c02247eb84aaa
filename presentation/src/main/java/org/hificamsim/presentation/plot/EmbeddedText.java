package org.hificamsim.presentation.plot;

import de.rototor.pdfbox.graphics2d.PdfBoxGraphics2DFontTextDrawer;
import java.awt.Color;
import java.awt.Font;
import java.io.IOException;
import java.io.InputStream;
import java.text.AttributedCharacterIterator;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.pdmodel.PDPageContentStream;
import org.apache.pdfbox.pdmodel.font.PDFont;
import org.apache.pdfbox.pdmodel.font.PDType0Font;
import org.apache.pdfbox.pdmodel.graphics.state.RenderingMode;

/**
 * Writes text into a PDF document in such a way that it can be searched and copied. The font is
 * Liberation Sans, which comes with PDFBox. Texts with letters that this font lacks become
 * outlines.
 */
final class EmbeddedText extends PdfBoxGraphics2DFontTextDrawer {
  private static final String FONT = "/org/apache/pdfbox/resources/ttf/LiberationSans-Regular.ttf";

  /** The width of the outlines that make letters bold, in points. */
  private static final float BOLD_OUTLINE = 0.35f;

  private final PDFont font;

  EmbeddedText(PDDocument document) throws IOException {
    try (InputStream file = PDFont.class.getResourceAsStream(FONT)) {
      this.font = PDType0Font.load(document, file, true);
    }
  }

  @Override
  public boolean canDrawText(AttributedCharacterIterator text, IFontTextDrawerEnv environment) {
    StringBuilder letters = new StringBuilder();
    for (char letter = text.first(); text.getIndex() < text.getEndIndex(); letter = text.next()) {
      letters.append(letter);
    }
    text.first();
    try {
      font.encode(letters.toString());
      return true;
    } catch (IOException | IllegalArgumentException e) {
      return false;
    }
  }

  @Override
  protected PDFont mapFont(Font drawn, IFontTextDrawerEnv environment) throws IOException {
    if (drawn.isBold() && environment.getPaint() instanceof Color color) {
      PDPageContentStream content = environment.getContentStream();
      content.setRenderingMode(RenderingMode.FILL_STROKE);
      content.setLineWidth(BOLD_OUTLINE);
      content.setStrokingColor(color);
    }
    return font;
  }
}
