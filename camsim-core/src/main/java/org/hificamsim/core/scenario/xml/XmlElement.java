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

/** An element of a scenario file, which knows where it stands. */
public final class XmlElement {
  private final XmlText source;
  private final String name;
  private final Place end;
  private final Map<String, String> attributes = new LinkedHashMap<>(0);
  private final List<XmlElement> children = new ArrayList<>(0);
  private StringBuilder text;

  /**
   * @param end where the start tag ends
   */
  public XmlElement(XmlText source, String name, Place end) {
    this.source = source;
    this.name = name;
    this.end = end;
  }

  public void add(XmlElement child) {
    children.add(child);
  }

  public void append(char[] characters, int start, int length) {
    if (text == null) {
      text = new StringBuilder(0);
    }
    text.append(characters, start, length);
  }

  public String name() {
    return name;
  }

  public Map<String, String> attributes() {
    return attributes;
  }

  public List<XmlElement> children() {
    return Collections.unmodifiableList(children);
  }

  /** The text directly inside, as it stands. */
  public String text() {
    return text == null ? "" : text.toString();
  }

  /** The lines of that text, which know where they stand. */
  public TextLines lines() {
    return new TextLines(end.file(), new StringReader(text()), end.line());
  }

  /** Where the start tag begins. */
  public Place place() {
    return source.tag(end);
  }

  /** Where an attribute of the start tag begins. */
  public Place place(String attribute) {
    return source.attribute(end, attribute);
  }

  /** Warns of the element. */
  public void warn(String problem) {
    source.warn(place().line(problem));
  }

  /** Warns of an attribute. */
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

  /** The elements below with this name, at any depth, in document order. */
  public List<XmlElement> all(String wanted) {
    return below().filter(element -> element.name.equals(wanted)).toList();
  }

  /**
   * The element below with this name; empty where there is none.
   *
   * @param expected what error lines say of a second one
   */
  public Optional<XmlElement> only(String wanted, String expected) {
    List<XmlElement> all = all(wanted);
    if (all.size() > 1) {
      throw all.get(1).place().error("a second <" + wanted + ">, expected " + expected);
    }
    return all.stream().findFirst();
  }

  /** All elements below, in document order. */
  public Stream<XmlElement> below() {
    return children.stream().flatMap(child -> Stream.concat(Stream.of(child), child.below()));
  }
}
