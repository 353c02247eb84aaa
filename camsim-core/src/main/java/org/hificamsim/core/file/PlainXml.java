package org.hificamsim.core.file;

import java.util.Locale;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParserFactory;
import org.xml.sax.SAXException;
import org.xml.sax.XMLReader;
import org.xml.sax.helpers.DefaultHandler;

/**
 * Readers of untrusted XML: no document types, no entities but the five of XML itself.
 *
 * <p>The JDK's SAX parser rather than its StAX one, which reports some faults on standard error,
 * others as message keys, and all in the machine's language.
 */
public final class PlainXml {
  private static final String FEATURES = "http://apache.org/xml/features/";

  private PlainXml() {}

  /** A reader that hands everything to one handler. */
  public static XMLReader reader(DefaultHandler handler) {
    try {
      XMLReader reader = plain();
      reader.setContentHandler(handler);
      reader.setErrorHandler(handler);
      reader.setEntityResolver(handler);
      return reader;
    } catch (SAXException | ParserConfigurationException e) {
      throw new IllegalStateException("the JDK's own XML parser knows these settings", e);
    }
  }

  private static XMLReader plain() throws ParserConfigurationException, SAXException {
    SAXParserFactory factory = SAXParserFactory.newDefaultInstance();
    factory.setFeature(FEATURES + "disallow-doctype-decl", true);
    factory.setFeature("http://xml.org/sax/features/external-general-entities", false);
    factory.setFeature("http://xml.org/sax/features/external-parameter-entities", false);
    factory.setFeature(FEATURES + "nonvalidating/load-external-dtd", false);
    XMLReader reader = factory.newSAXParser().getXMLReader();
    reader.setProperty("http://apache.org/xml/properties/locale", Locale.ROOT);
    return reader;
  }
}
