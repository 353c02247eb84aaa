package org.hificamsim.core.scenario;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** An element of a scenario file, which knows where it stands. */
final class XmlElement {
  private final XmlText source;
  private final int endLine;
  private final int endColumn;
  private final String name;
  private final Map<String, String> attributes = new LinkedHashMap<>();
  private final List<XmlElement> children = new ArrayList<>();
  private final StringBuilder text = new StringBuilder();

  /**
   * @param endLine where the start tag ends, as the parser tells it
   */
  XmlElement(XmlText source, String name, int endLine, int endColumn) {
    this.source = source;
    this.name = name;
    this.endLine = endLine;
    this.endColumn = endColumn;
  }

  String name() {
    return name;
  }

  Map<String, String> attributes() {
    return attributes;
  }

  List<XmlElement> children() {
    return children;
  }

  StringBuilder text() {
    return text;
  }

  /** Where the start tag begins. */
  Place place() {
    return source.tag(endLine, endColumn);
  }

  /** Where an attribute of the start tag begins. */
  Place place(String attribute) {
    return source.attribute(endLine, endColumn, attribute);
  }

  /** The elements below with this name, at any depth, in document order. */
  List<XmlElement> all(String wanted) {
    return below().filter(element -> element.name.equals(wanted)).toList();
  }

  /** All elements below, in document order. */
  Stream<XmlElement> below() {
    return children.stream().flatMap(child -> Stream.concat(Stream.of(child), child.below()));
  }
}
