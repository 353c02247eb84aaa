package org.hificamsim.core.scenario.xml;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import java.util.function.Consumer;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.PlainXml;
import org.hificamsim.core.file.TextLines;
import org.xml.sax.InputSource;
import org.xml.sax.SAXParseException;

/**
 * Reads untrusted XML of bounded size and depth as a tree of elements.
 *
 * <p>Namespaces are ignored: {@code a:camera} is a name like any other.
 */
public final class XmlParser extends PlainXml {
  /** The greatest size in bytes; a scenario of 100,000 cameras takes about 12 million. */
  static final int MAX_BYTES = 64 << 20;

  /** The greatest depth of nested elements; a real scenario has six. */
  static final int MAX_DEPTH = 32;

  /** The greatest number of elements and attributes; 100,000 cameras have about a million. */
  static final int MAX_PARTS = 4_000_000;

  // Parts of the parser's messages.
  private static final String NO_DOCTYPE = "disallow-doctype-decl";
  private static final String CUT_OFF = "must start and end within the same entity";

  private final XmlText text;
  private final Deque<XmlElement> open = new ArrayDeque<>();
  private XmlElement root;
  private int parts;

  private XmlParser(XmlText text) {
    this.text = text;
  }

  /**
   * Parses a file and returns its root element.
   *
   * @param warnings receives one line for each warning about an element
   * @throws InputException if the file cannot be read, is too big, or is not plain XML
   */
  public static XmlElement parse(Path path, Consumer<String> warnings) {
    String file = path.toString();
    byte[] bytes = bytes(path);
    XmlParser parser = new XmlParser(new XmlText(file, bytes, warnings));
    parser.readSource(file, new InputSource(new ByteArrayInputStream(bytes)));
    return parser.root;
  }

  private static byte[] bytes(Path path) {
    try (InputStream in = TextLines.stream(path)) {
      byte[] bytes = Files.size(path) > MAX_BYTES ? null : in.readNBytes(MAX_BYTES + 1);
      if (bytes == null || bytes.length > MAX_BYTES) {
        throw new Place(path.toString(), 1, 1)
            .error("the file is too big, expected at most " + MAX_BYTES + " bytes");
      }
      return bytes;
    } catch (IOException e) {
      throw TextLines.unreadable(path.toString(), 1, e);
    }
  }

  @Override
  public void startElement(
      String uri, String local, String name, org.xml.sax.Attributes attributes) {
    XmlElement element = new XmlElement(text, name, place());
    for (int i = 0; i < attributes.getLength(); i++) {
      element.attributes().put(attributes.getQName(i), attributes.getValue(i));
    }
    checkSize(element);
    if (root == null) {
      root = element;
      text.setEncoding(encoding());
    } else {
      open.getLast().add(element);
    }
    open.addLast(element);
  }

  private void checkSize(XmlElement element) {
    if (open.size() >= MAX_DEPTH) {
      throw element
          .place()
          .error("<%s> is nested too deep, expected at most %s levels", element.name(), MAX_DEPTH);
    }
    parts += 1 + element.attributes().size();
    if (parts > MAX_PARTS) {
      throw element
          .place()
          .error("the file is too big, expected at most " + MAX_PARTS + " elements, attributes");
    }
  }

  @Override
  public void endElement(String uri, String local, String name) {
    open.removeLast();
  }

  @Override
  public void characters(char[] characters, int start, int length) {
    open.getLast().append(characters, start, length);
  }

  @Override
  protected InputException fault(SAXParseException e) {
    String words = String.valueOf(e.getMessage());
    Place place = place(e.getLineNumber(), e.getColumnNumber());
    text.setEncoding(encoding());
    Optional<InputException> undecodable = text.undecodable();
    if (undecodable.isPresent()) {
      return undecodable.get();
    }
    if (words.contains(NO_DOCTYPE)) {
      return text.tag(place)
          .error("a document type declaration (<!DOCTYPE), expected a scenario without one");
    }
    if (words.contains(CUT_OFF) && !open.isEmpty()) {
      String name = open.getLast().name();
      return place.error("the file ends inside <" + name + ">, expected </" + name + ">");
    }
    return place.error(
        "not well-formed XML, expected a scenario file: %s", words.replaceAll("\\s+", " "));
  }
}
