package org.hificamsim.core.scenario;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import javax.xml.stream.Location;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.hificamsim.core.InputException;

/**
 * Reads XML that nobody vouches for: no document types, no entities but the five of XML itself,
 * bounded size and depth.
 */
final class XmlParser {
  /** Bytes; a scenario of 100,000 cameras takes about 12 million. */
  static final int MOST_BYTES = 64 << 20;

  /** Elements inside each other; a real scenario has six. */
  static final int MOST_DEPTH = 32;

  private final String file;
  private final XmlText text;

  private XmlParser(String file, byte[] bytes) {
    this.file = file;
    this.text = new XmlText(file, bytes);
  }

  /**
   * The root element of a file.
   *
   * @throws InputException when the file cannot be read, is too big, or is not plain XML
   */
  static XmlElement parse(Path path) {
    byte[] bytes = bytes(path);
    return new XmlParser(path.toString(), bytes).parse(bytes);
  }

  private static byte[] bytes(Path path) {
    Place start = new Place(path.toString(), 1, 1);
    try (InputStream in = Files.newInputStream(path)) {
      byte[] bytes = in.readNBytes(MOST_BYTES + 1);
      if (bytes.length > MOST_BYTES) {
        throw start.error("the file is too big, expected at most " + MOST_BYTES + " bytes");
      }
      return bytes;
    } catch (NoSuchFileException e) {
      throw new InputException(start + ": no such file, expected a scenario file (XML)", e);
    } catch (IOException e) {
      throw new InputException(
          start + ": cannot be read, expected a scenario file (XML): " + e.getMessage(), e);
    }
  }

  private XmlElement parse(byte[] bytes) {
    XMLStreamReader reader = null;
    try {
      reader = factory().createXMLStreamReader(new ByteArrayInputStream(bytes));
      String declared = reader.getCharacterEncodingScheme();
      text.encoding(declared != null ? declared : reader.getEncoding());
      return tree(reader);
    } catch (XMLStreamException e) {
      throw new InputException(place(e.getLocation()) + ": " + reason(e), e);
    } catch (InputException e) {
      throw e;
    } catch (RuntimeException e) {
      // The JDK's parser lets some encoding faults through as unchecked exceptions.
      Location location = reader == null ? null : reader.getLocation();
      throw new InputException(
          place(location) + ": not well-formed XML: " + oneLine(String.valueOf(e.getMessage())), e);
    }
  }

  private XmlElement tree(XMLStreamReader reader) throws XMLStreamException {
    XmlElement root = null;
    Deque<XmlElement> open = new ArrayDeque<>();
    while (reader.hasNext()) {
      switch (reader.next()) {
        case XMLStreamConstants.START_ELEMENT -> {
          XmlElement element = element(reader);
          if (open.size() >= MOST_DEPTH) {
            throw element
                .place()
                .error(
                    "<"
                        + element.name()
                        + "> is nested too deep, expected at most "
                        + MOST_DEPTH
                        + " levels");
          }
          if (root == null) {
            root = element;
          } else {
            open.getLast().children().add(element);
          }
          open.addLast(element);
        }
        case XMLStreamConstants.END_ELEMENT -> open.removeLast();
        case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA -> {
          if (!reader.isWhiteSpace()) {
            open.getLast().text().append(reader.getText());
          }
        }
        case XMLStreamConstants.DTD ->
            throw place(reader.getLocation())
                .error("a document type declaration, expected a scenario without one");
        case XMLStreamConstants.ENTITY_REFERENCE ->
            throw place(reader.getLocation())
                .error("entity &" + reader.getLocalName() + ";, expected none but XML's own five");
        default -> {
          // comments and processing instructions say nothing
        }
      }
    }
    return root;
  }

  private XmlElement element(XMLStreamReader reader) {
    Location end = reader.getLocation();
    XmlElement element =
        new XmlElement(text, reader.getLocalName(), end.getLineNumber(), end.getColumnNumber());
    for (int i = 0; i < reader.getAttributeCount(); i++) {
      element.attributes().put(reader.getAttributeLocalName(i), reader.getAttributeValue(i));
    }
    return element;
  }

  private Place place(Location location) {
    return location == null || location.getLineNumber() < 1
        ? new Place(file, 1, 1)
        : new Place(file, location.getLineNumber(), Math.max(1, location.getColumnNumber()));
  }

  /** The parser's own words, without its place prefix. */
  private static String reason(XMLStreamException e) {
    String message = oneLine(String.valueOf(e.getMessage()));
    int at = message.indexOf("Message: ");
    return "not well-formed XML: " + (at < 0 ? message : message.substring(at + 9));
  }

  private static String oneLine(String message) {
    String flat = message.replaceAll("\\s+", " ").strip();
    return flat.length() > 300 ? flat.substring(0, 300) : flat;
  }

  private static XMLInputFactory factory() {
    XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    factory.setProperty(XMLInputFactory.IS_REPLACING_ENTITY_REFERENCES, false);
    factory.setXMLResolver(
        (publicId, systemId, base, namespace) -> {
          throw new XMLStreamException("external entity " + systemId + ", expected none");
        });
    return factory;
  }
}
