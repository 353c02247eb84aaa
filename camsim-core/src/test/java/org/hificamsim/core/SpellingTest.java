package org.hificamsim.core;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;

class SpellingTest {
  private enum Season {
    EARLY_SPRING,
    IN_MID_WINTER
  }

  @Test
  void spellsConstantsInLowerCaseWithHyphens() {
    assertEquals("in-mid-winter", Spelling.of(Season.IN_MID_WINTER));
    assertEquals("early-spring, in-mid-winter", Spelling.all(Season.class));
  }

  @Test
  void findsConstantsOnlyByTheirSpelling() {
    assertEquals(Optional.of(Season.IN_MID_WINTER), Spelling.find(Season.class, "in-mid-winter"));
    assertEquals(Optional.empty(), Spelling.find(Season.class, "IN_MID_WINTER"));
  }
}
