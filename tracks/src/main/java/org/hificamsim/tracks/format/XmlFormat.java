package org.hificamsim.tracks.format;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.Fields;
import org.hificamsim.core.file.PlainXml;
import org.hificamsim.core.file.TextLines;
import org.xml.sax.Attributes;
import org.xml.sax.InputSource;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.SAXParseException;
import org.xml.sax.helpers.DefaultHandler;

/** Reads an XML file of any size from front to back; an implementer takes its elements. */
public abstract class XmlFormat extends DefaultHandler {
  private String file;
  private Locator locator;

  /**
   * Reads a file.
   *
   * @throws InputException with the place, when it is no XML, or what the implementer finds
   */
  protected final void parse(Path path) {
    file = path.toString();
    try (InputStream in = TextLines.stream(path)) {
      PlainXml.reader(this).parse(new InputSource(in));
    } catch (SAXParseException e) {
      throw new InputException(fault(e).getMessage(), e);
    } catch (SAXException e) {
      throw new InputException(
          place().error("not well-formed XML, expected a whole file").getMessage(), e);
    } catch (IOException e) {
      throw TextLines.unreadable(file, Math.max(1, place().line()), e);
    }
  }

  private InputException fault(SAXParseException e) {
    Place place = new Place(file, Math.max(1, e.getLineNumber()), Math.max(1, e.getColumnNumber()));
    return place.error("not well-formed XML, or cut off, expected a whole file: " + e.getMessage());
  }

  /** Where the reader is: at the end of a start tag. */
  protected final Place place() {
    return new Place(
        file, Math.max(1, locator.getLineNumber()), Math.max(1, locator.getColumnNumber()));
  }

  /** An attribute that must be there. */
  protected final String text(Attributes attributes, String element, String name) {
    String value = attributes.getValue(name);
    if (value == null) {
      throw place().error("<" + element + "> has no " + name + ", expected one");
    }
    return value;
  }

  /** A number of at most 1e9 in size. */
  protected final double number(Attributes attributes, String element, String name) {
    String text = text(attributes, element, name);
    double value = Fields.value(text);
    if (!(Math.abs(value) <= 1e9)) {
      throw place()
          .error(
              "<%s> %s is '%s', expected a number from -1e9 to 1e9".formatted(element, name, text));
    }
    return value;
  }

  @Override
  public final void setDocumentLocator(Locator newLocator) {
    locator = newLocator;
  }

  @Override
  public final InputSource resolveEntity(String publicId, String systemId) throws SAXException {
    throw new SAXParseException("external entity " + systemId + ", expected none", locator);
  }

  @Override
  public final void fatalError(SAXParseException e) throws SAXException {
    throw e;
  }
}
