package org.hificamsim.core.scenario;

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
final class XmlElement {
  private final XmlText source;
  private final String name;
  private final Place end;
  private final Map<String, String> attributes = new LinkedHashMap<>(0);
  private final List<XmlElement> children = new ArrayList<>(0);
  private StringBuilder text;

  /**
   * @param end where the start tag ends
   */
  XmlElement(XmlText source, String name, Place end) {
    this.source = source;
    this.name = name;
    this.end = end;
  }

  void add(XmlElement child) {
    children.add(child);
  }

  void append(char[] characters, int start, int length) {
    if (text == null) {
      text = new StringBuilder(0);
    }
    text.append(characters, start, length);
  }

  String name() {
    return name;
  }

  Map<String, String> attributes() {
    return attributes;
  }

  List<XmlElement> children() {
    return Collections.unmodifiableList(children);
  }

  /** The text directly inside, as it stands. */
  String text() {
    return text == null ? "" : text.toString();
  }

  /** The lines of that text, which know where they stand. */
  TextLines lines() {
    return new TextLines(end.file(), new StringReader(text()), end.line());
  }

  /** Where the start tag begins. */
  Place place() {
    return source.tag(end);
  }

  /** Where an attribute of the start tag begins. */
  Place place(String attribute) {
    return source.attribute(end, attribute);
  }

  /** Warns of the element. */
  void warn(String problem) {
    source.warn(place().line(problem));
  }

  /** Warns of an attribute. */
  void warn(String attribute, String problem) {
    source.warn(place(attribute).line(problem));
  }

  /** An error about an attribute's value, or that it is missing. */
  InputException invalid(String attribute, String expected) {
    String value = attributes.get(attribute);
    return value == null
        ? place().error("<%s> has no %s, expected %s".formatted(name, attribute, expected))
        : place(attribute).invalid("<" + name + "> " + attribute, value, expected);
  }

  /** The elements below with this name, at any depth, in document order. */
  List<XmlElement> all(String wanted) {
    return below().filter(element -> element.name.equals(wanted)).toList();
  }

  /**
   * The element below with this name; empty where there is none.
   *
   * @param expected what error lines say of a second one
   */
  Optional<XmlElement> only(String wanted, String expected) {
    List<XmlElement> all = all(wanted);
    if (all.size() > 1) {
      throw all.get(1).place().error("a second <" + wanted + ">, expected " + expected);
    }
    return all.stream().findFirst();
  }

  /** All elements below, in document order. */
  Stream<XmlElement> below() {
    return children.stream().flatMap(child -> Stream.concat(Stream.of(child), child.below()));
  }
}
