package org.hificamsim.core.scenario.spec;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Type;

/**
 * The links between cameras at the start of a scenario.
 *
 * @param isStatic the file's {@code static} attribute
 * @param neighbours for each camera, the names of the cameras it is linked to, in document order;
 *     they need not exist
 */
public record VisionGraph(boolean isStatic, Map<String, List<String>> neighbours) {
  public static final Element<VisionGraph> ELEMENT =
      Element.<VisionGraph>of(
              "visiongraph",
              """
              Which cameras each camera hands targets over to at the start.
              static: whether links also go the other way round
              """)
          .holds("graphnode*");
  public static final Property<VisionGraph, Boolean> STATIC =
      ELEMENT.attribute(
          "static",
          new Type<>(
              "true or false",
              Type.words(Stream.of("true", "false")),
              Boolean::parseBoolean,
              String::valueOf),
          false);

  public static final Element<VisionGraph> NODE =
      Element.<VisionGraph>of(
              "graphnode",
              """
              A camera that hands over.
              name: a camera; of two nodes with one name the later counts
              """)
          .holds("neighbour*");
  public static final Property<VisionGraph, String> NODE_NAME = NODE.required("name", Type.CAMERA);

  public static final Element<VisionGraph> NEIGHBOUR =
      Element.of(
          "neighbour",
          """
          A camera that it hands over to.
          name: a camera; need not exist
          """);
  public static final Property<VisionGraph, String> NEIGHBOUR_NAME =
      NEIGHBOUR.required("name", Type.CAMERA);

  /** Copies the map. */
  public VisionGraph {
    neighbours = Collections.unmodifiableMap(new LinkedHashMap<>(neighbours));
  }
}
