package org.hificamsim.network.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.scenario.VisionGraph;
import org.junit.jupiter.api.Test;

/** The vision graph: links that fade, grow, or do neither. */
class LinksTest {
  @Test
  void linksFadeByAHalfPercentAndGrowByOne() {
    NameLinks links = new NameLinks(3, List.of(1), false);
    links.decay();
    assertEquals(0.995, links.strength(1, 0));
    links.strengthen(1, 0);
    links.strengthen(2, 0);
    assertEquals(1.995, links.strength(1, 0));
    assertEquals(1.0, links.strength(2, 0));
    assertEquals(Links.NONE, links.strength(0, 0));
    assertEquals(1.995, links.strongest(0));
    assertEquals(2, links.count());
  }

  @Test
  void frozenLinksStayUntilTheyThaw() {
    NameLinks links = new NameLinks(3, List.of(1, 1), true);
    links.decay();
    links.strengthen(2, 0);
    assertEquals(1.0, links.strength(1, 0));
    assertEquals(1, links.count());
    links.thaw();
    links.decay();
    assertEquals(0.995, links.strength(1, 0));
  }

  @Test
  void linksByCategoryAreForTargetsOfThatCategoryAlone() {
    CategoryLinks links = new CategoryLinks(3, 4, target -> target);
    links.strengthen(1, 2);
    links.strengthen(1, 0);
    assertEquals(1.0, links.strength(1, 2));
    assertEquals(Links.NONE, links.strength(1, 3));
    assertEquals(0, links.strongest(3));
    assertEquals(0, links.strongest(0), "category 0 has no links");
    links.decay();
    assertEquals(0.995, links.strongest(2));
  }

  @Test
  void theFilesGraphGivesLinksForwardAndBackwardAndToUnknownNames() {
    VisionGraph graph =
        new VisionGraph(true, Map.of("A", List.of("B", "Nobody"), "C", List.of("A")));
    InitialLinks links = new InitialLinks(List.of("A", "B", "C"), Optional.of(graph));
    assertEquals(4, links.names());
    assertEquals(List.of(1, 3), links.of("A", false));
    assertEquals(List.of(1, 3, 2), links.of("A", true));
    assertEquals(List.of(), links.of("B", false));
    assertEquals(List.of(0), links.of("B", true));
  }
}
