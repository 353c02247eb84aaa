package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.scenario.spec.VisionGraph;
import org.junit.jupiter.api.Test;

/** Tests the links of a scenario's vision graph. */
class InitialLinksTest {
  @Test
  void graphGivesForwardReverseAndUnknownLinks() {
    VisionGraph graph =
        new VisionGraph(true, Map.of("A", List.of("B", "Nobody"), "C", List.of("A")));
    InitialLinks links = new InitialLinks(List.of("A", "B", "C"), Optional.of(graph));
    assertEquals(4, links.names());
    assertEquals(List.of(1, 3), links.links("A", false));
    assertEquals(List.of(1, 3, 2), links.links("A", true));
    assertEquals(List.of(), links.links("B", false));
    assertEquals(List.of(0), links.links("B", true));
  }
}
