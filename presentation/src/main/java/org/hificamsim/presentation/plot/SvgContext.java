package org.hificamsim.presentation.plot;

import java.text.DecimalFormat;
import org.apache.batik.svggen.DefaultErrorHandler;
import org.apache.batik.svggen.DefaultExtensionHandler;
import org.apache.batik.svggen.DefaultStyleHandler;
import org.apache.batik.svggen.SVGGeneratorContext;
import org.apache.batik.svggen.SVGIDGenerator;
import org.w3c.dom.Document;

/**
 * How Batik writes a figure. Numbers are formatted by an object of its own: Batik's is one for all
 * documents, and a {@link DecimalFormat} is not promised to serve two threads.
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
}
