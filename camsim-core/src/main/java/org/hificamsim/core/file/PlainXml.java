package org.hificamsim.core.file;

import java.io.IOException;
import java.io.InputStream;
import java.io.StringReader;
import java.io.UnsupportedEncodingException;
import java.nio.charset.Charset;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.parsers.SAXParser;
import javax.xml.parsers.SAXParserFactory;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.XMLReader;
import org.xml.sax.ext.Locator2;
import org.xml.sax.helpers.DefaultHandler;
import org.xml.sax.helpers.LocatorImpl;

/**
 * Reads untrusted XML of any size as a stream; subclasses handle its elements. Document types and
 * all entities except the five of XML are refused, unless the subclass {@linkplain
 * #allowsDocumentType allows} them; even then nothing that the file names is opened.
 *
 * <p>It uses the JDK's SAX parser: the StAX parser reports some errors on standard error, others as
 * message keys, and all in the language of the machine.
 */
public abstract class PlainXml extends DefaultHandler {
  private static final List<String> EXTERNAL =
      List.of(
          "http://xml.org/sax/features/external-general-entities",
          "http://xml.org/sax/features/external-parameter-entities",
          "http://apache.org/xml/features/nonvalidating/load-external-dtd");

  private String file = "";
  private Locator locator = new LocatorImpl();

  /**
   * Reads a file, decompressed if its name ends in {@code .gz}.
   *
   * @throws InputException with the place, if it is not XML or the subclass finds an error
   */
  public final void readFile(Path path) {
    try (InputStream in = TextLines.stream(path)) {
      readSource(path.toString(), new InputSource(in));
    } catch (IOException e) {
      throw TextLines.unreadable(path.toString(), 1, e);
    }
  }

  /**
   * Reads a source.
   *
   * @param name the name of the file, for messages
   * @throws InputException with the place, if it is not XML or the subclass finds an error
   */
  protected final void readSource(String name, InputSource source) {
    file = name;
    try {
      parser().parse(source, this);
    } catch (SAXParseException e) {
      throw new InputException(fault(e).getMessage(), e);
    } catch (SAXException e) {
      // An internal error of the parser, as after <!DOCTYPE> inside <root>.
      SAXParseException fault = new SAXParseException(e.getMessage(), locator);
      throw new InputException(fault(fault).getMessage(), e);
    } catch (UnsupportedEncodingException e) {
      String problem = "The encoding \"" + e.getMessage() + "\" is not known.";
      throw new InputException(fault(new SAXParseException(problem, locator)).getMessage(), e);
    } catch (IOException e) {
      throw TextLines.unreadable(file, place().line(), e);
    }
  }

  /**
   * Whether the file may have a document type. Its own entities are then expanded, within the JDK's
   * limits; others are skipped.
   */
  protected boolean allowsDocumentType() {
    return false;
  }

  /** Reads an external entity as an empty one. */
  @Override
  public final InputSource resolveEntity(String publicId, String systemId) {
    return new InputSource(new StringReader(""));
  }

  private SAXParser parser() throws SAXException {
    try {
      SAXParser parser = SAXParserFactory.newDefaultInstance().newSAXParser();
      XMLReader reader =
          parser.getXMLReader(); // the factory would try each feature on a new parser
      reader.setFeature(
          "http://apache.org/xml/features/disallow-doctype-decl", !allowsDocumentType());
      for (String external : EXTERNAL) {
        reader.setFeature(external, false);
      }
      reader.setProperty("http://apache.org/xml/properties/locale", Locale.ROOT);
      return parser;
    } catch (ParserConfigurationException e) {
      throw new IllegalStateException("the JDK's own XML parser knows these settings", e);
    }
  }

  /** The error about a file that is not plain XML. */
  protected InputException fault(SAXParseException e) {
    return place(e.getLineNumber(), e.getColumnNumber())
        .error("not well-formed XML, or cut off, expected a whole file: " + e.getMessage());
  }

  /** The encoding of the file. */
  protected final String encoding() {
    String known = locator instanceof Locator2 with ? with.getEncoding() : null;
    return known == null || !Charset.isSupported(known) ? "UTF-8" : known;
  }

  /** The current place: the end of a start tag. */
  protected final Place place() {
    return place(locator.getLineNumber(), locator.getColumnNumber());
  }

  /** A place reported by the parser, which is -1 for an empty file. */
  protected final Place place(int line, int column) {
    return new Place(file, Math.max(1, line), Math.max(1, column));
  }

  /** Reads an attribute that is required. */
  protected final String text(Attributes attributes, String element, String name) {
    String value = attributes.getValue(name);
    if (value == null) {
      throw place().error("<" + element + "> has no " + name + ", expected one");
    }
    return value;
  }

  /** Reads a required number from -1e9 to 1e9. */
  protected final double number(Attributes attributes, String element, String name) {
    String text = text(attributes, element, name);
    double value = Fields.value(text);
    if (!(Math.abs(value) <= 1e9)) {
      throw place().invalid("<" + element + "> " + name, text, "a number from -1e9 to 1e9");
    }
    return value;
  }

  @Override
  public final void setDocumentLocator(Locator newLocator) {
    locator = newLocator;
  }
}
