package org.hificamsim.presentation.plot;

import java.awt.Image;
import java.awt.image.BufferedImage;
import java.awt.image.RenderedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.text.DecimalFormat;
import java.util.Base64;
import javax.imageio.ImageIO;
import org.apache.batik.svggen.DefaultErrorHandler;
import org.apache.batik.svggen.DefaultExtensionHandler;
import org.apache.batik.svggen.DefaultImageHandler;
import org.apache.batik.svggen.DefaultStyleHandler;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGGraphics2DIOException;
import org.apache.batik.svggen.SVGIDGenerator;
import org.w3c.dom.Document;
import org.w3c.dom.Element;

/**
 * The settings by which Batik draws a figure. Each figure has a number format of its own, because
 * Batik shares one among all documents and a {@link DecimalFormat} is not thread-safe.
 */
final class SvgContext extends SVGGeneratorContext {
  SvgContext(Document document) {
    super(document);
    setIDGenerator(new SVGIDGenerator());
    setExtensionHandler(new DefaultExtensionHandler());
    setStyleHandler(new DefaultStyleHandler());
    setErrorHandler(new DefaultErrorHandler());
    setImageHandler(new EmbeddedImages());
    setComment("HiFi-CamSim");
    setPrecision(2);
    decimalFormat = (DecimalFormat) decimalFormat.clone();
  }

  /** Embeds images in the SVG document as PNG, so that it needs no other file. */
  private static final class EmbeddedImages extends DefaultImageHandler {
    private static final String XLINK = "http://www.w3.org/1999/xlink";

    @Override
    protected void handleHREF(Image image, Element element, SVGGeneratorContext context)
        throws SVGGraphics2DIOException {
      BufferedImage drawn =
          new BufferedImage(
              image.getWidth(null), image.getHeight(null), BufferedImage.TYPE_INT_ARGB);
      drawn.createGraphics().drawImage(image, 0, 0, null);
      handleHREF((RenderedImage) drawn, element, context);
    }

    @Override
    protected void handleHREF(RenderedImage image, Element element, SVGGeneratorContext context)
        throws SVGGraphics2DIOException {
      ByteArrayOutputStream png = new ByteArrayOutputStream();
      try {
        ImageIO.write(image, "png", png);
      } catch (IOException e) {
        throw new SVGGraphics2DIOException(e);
      }
      String data = Base64.getEncoder().encodeToString(png.toByteArray());
      element.setAttributeNS(XLINK, "xlink:href", "data:image/png;base64," + data);
    }
  }
}
