package org.hificamsim.network.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests links of the vision graph that fade, grow, or are frozen. */
class LinksTest {
  @Test
  void linksFadeByHalfPercentAndGrowByOne() {
    Links links = Links.plain(3, List.of(1), false);
    links.fade();
    assertEquals(0.995, links.strength(1, 0));
    links.strengthen(1, 0);
    links.strengthen(2, 0);
    assertEquals(1.995, links.strength(1, 0));
    assertEquals(1.0, links.strength(2, 0));
    assertEquals(Links.NONE, links.strength(0, 0));
    assertEquals(1.995, links.strongest(0));
    assertEquals(2, links.linked().cardinality());
  }

  @Test
  void frozenLinksKeepStrengthUntilThawed() {
    Links links = Links.plain(3, List.of(1, 1), true);
    links.fade();
    links.strengthen(2, 0);
    assertEquals(1.0, links.strength(1, 0));
    assertEquals(1, links.linked().cardinality());
    links.thaw();
    links.fade();
    assertEquals(0.995, links.strength(1, 0));
  }

  @Test
  void linksByCategoryApplyToTheirCategoryOnly() {
    Links links = Links.byCategory(3, 4, target -> target);
    links.strengthen(1, 2);
    links.strengthen(1, 0);
    assertEquals(1.0, links.strength(1, 2));
    assertEquals(Links.NONE, links.strength(1, 3));
    assertEquals(0, links.strongest(3));
    assertEquals(0, links.strongest(0), "category 0 has no links");
    links.fade();
    assertEquals(0.995, links.strongest(2));
  }
}
