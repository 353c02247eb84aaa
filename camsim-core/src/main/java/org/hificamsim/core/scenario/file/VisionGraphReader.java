package org.hificamsim.core.scenario.file;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.Place;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.spec.VisionGraph;
import org.hificamsim.core.scenario.xml.XmlElement;

/** Reads the links between cameras at the start. */
public final class VisionGraphReader {
  private VisionGraphReader() {}

  /** Reads the graph of a file; empty if it has none, or one without nodes. */
  public static Optional<VisionGraph> read(XmlElement root) {
    List<XmlElement> graphs = root.all(VisionGraph.ELEMENT.name());
    if (graphs.isEmpty() || graphs.get(0).all(VisionGraph.NODE.name()).isEmpty()) {
      return Optional.empty();
    }
    Map<String, List<String>> neighbours = new LinkedHashMap<>();
    for (XmlElement node : root.all(VisionGraph.NODE.name())) {
      String camera = value(node, VisionGraph.NODE, VisionGraph.NODE_NAME);
      if (neighbours.remove(camera) != null) {
        node.warn(
            "name",
            "a second <graphnode> for '%s', the last one counts"
                .formatted(Place.shortened(camera)));
      }
      neighbours.put(
          camera,
          node.all(VisionGraph.NEIGHBOUR.name()).stream()
              .map(xml -> value(xml, VisionGraph.NEIGHBOUR, VisionGraph.NEIGHBOUR_NAME))
              .toList());
    }
    boolean isStatic = value(graphs.get(0), VisionGraph.ELEMENT, VisionGraph.STATIC);
    return Optional.of(new VisionGraph(isStatic, neighbours));
  }

  private static <T> T value(
      XmlElement xml, Element<VisionGraph> element, Property<VisionGraph, T> property) {
    Attributes<VisionGraph> attributes = new Attributes<>(xml, element);
    attributes.warnOfUnknown();
    return attributes.get(property);
  }
}
