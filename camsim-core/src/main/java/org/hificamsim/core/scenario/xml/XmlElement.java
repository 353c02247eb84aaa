package org.hificamsim.core.scenario.xml;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;

/** An XML element with its place in the file. */
public final class XmlElement {
  private final XmlText source;
  private final String name;
  private final Place end;
  private final Map<String, String> attributes = new LinkedHashMap<>(0);
  private final List<XmlElement> children = new ArrayList<>(0);
  private StringBuilder text;

  /**
   * Creates an element without attributes and children.
   *
   * @param end the end of its start tag
   */
  public XmlElement(XmlText source, String name, Place end) {
    this.source = source;
    this.name = name;
    this.end = end;
  }

  /** Adds a child. */
  public void add(XmlElement child) {
    children.add(child);
  }

  /** Appends to the text directly inside. */
  public void append(char[] characters, int start, int length) {
    if (text == null) {
      text = new StringBuilder(0);
    }
    text.append(characters, start, length);
  }

  /** The name of the element. */
  public String name() {
    return name;
  }

  /** The attributes by name, modifiable. */
  public Map<String, String> attributes() {
    return attributes;
  }

  /** The children, in document order. */
  public List<XmlElement> children() {
    return Collections.unmodifiableList(children);
  }

  /** The text directly inside. */
  public String text() {
    return text == null ? "" : text.toString();
  }

  /** The lines of the text directly inside, with their places. */
  public TextLines lines() {
    return new TextLines(end.file(), new StringReader(text()), end.line());
  }

  /** The place where the start tag begins. */
  public Place place() {
    return source.tag(end);
  }

  /** The place of an attribute of the start tag. */
  public Place place(String attribute) {
    return source.attribute(end, attribute);
  }

  /** Reports a warning about the element. */
  public void warn(String problem) {
    source.warn(place().line(problem));
  }

  /** Reports a warning about an attribute. */
  public void warn(String attribute, String problem) {
    source.warn(place(attribute).line(problem));
  }

  /** An error about an attribute's value, or that it is missing. */
  public InputException invalid(String attribute, String expected) {
    String value = attributes.get(attribute);
    return value == null
        ? place().error("<%s> has no %s, expected %s".formatted(name, attribute, expected))
        : place(attribute).invalid("<" + name + "> " + attribute, value, expected);
  }

  /** The descendants with a name, in document order. */
  public List<XmlElement> all(String wanted) {
    return descendants().filter(element -> element.name.equals(wanted)).toList();
  }

  /**
   * The only descendant with a name; empty if there is none.
   *
   * @param expected what is expected instead of a second one, for messages
   * @throws InputException if there are several
   */
  public Optional<XmlElement> only(String wanted, String expected) {
    List<XmlElement> all = all(wanted);
    if (all.size() > 1) {
      throw all.get(1).place().error("a second <" + wanted + ">, expected " + expected);
    }
    return all.stream().findFirst();
  }

  /** All descendants, in document order. */
  public Stream<XmlElement> descendants() {
    return children.stream().flatMap(child -> Stream.concat(Stream.of(child), child.descendants()));
  }
}
