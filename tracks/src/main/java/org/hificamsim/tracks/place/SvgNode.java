package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.hificamsim.core.Place;

/** An element of an SVG. */
final class SvgNode {
  private static final Set<String> SHAPES =
      Set.of("line", "polyline", "polygon", "rect", "path", "circle", "ellipse", "use");

  private final String name;
  private final Map<String, String> attributes;
  private final SvgNode parent;
  private final Place place;
  private final List<SvgNode> children = new ArrayList<>();

  /**
   * @param name without a prefix
   * @param parent null for the root
   */
  SvgNode(String name, Map<String, String> attributes, SvgNode parent, Place place) {
    this.name = name;
    this.attributes = attributes;
    this.parent = parent;
    this.place = place;
    if (parent != null) {
      parent.children.add(this);
    }
  }

  String name() {
    return name;
  }

  /** The element around; null for the root. */
  SvgNode parent() {
    return parent;
  }

  /** The end of the start tag. */
  Place place() {
    return place;
  }

  List<SvgNode> children() {
    return children;
  }

  boolean has(String attribute) {
    return attributes.containsKey(attribute);
  }

  /** The text of an attribute; empty without one. */
  String text(String attribute) {
    return attributes.getOrDefault(attribute, "").strip();
  }

  /** The classes. */
  List<String> classes() {
    String text = text("class");
    return text.isEmpty() ? List.of() : List.of(text.split("\\s+"));
  }

  /** Whether a shape is drawn for the element itself, or, for a {@code use}, somewhere below it. */
  boolean isShape() {
    return SHAPES.contains(name);
  }

  /** The number of shapes in the element. */
  int shapes() {
    return (isShape() ? 1 : 0) + children.stream().mapToInt(SvgNode::shapes).sum();
  }
}
