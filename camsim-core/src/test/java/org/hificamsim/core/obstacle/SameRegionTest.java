package org.hificamsim.core.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/**
 * Tests that regions answer as many questions without looking at obstacles as before, which is what
 * makes them fast. A change of the precomputed data shows its effect here.
 */
class SameRegionTest {
  private static final int PLACES = 200;

  // Obstacles met in all sectors of all places; sectors that hide everything far away; sums of
  // squared distances within which sectors are clear, and beyond which they hide everything.
  private static final String KNOWN = "9157 4636 23015 25223";

  @Test
  void fixedPlacesHaveRecordedCounts() {
    int[] counts = new int[2];
    double[] sums = new double[2];
    for (int seed = 0; seed < PLACES; seed++) {
      RandomPlace place = new RandomPlace(seed);
      Obstacles obstacles = place.obstacles(10, false);
      Point at = place.point();
      VisibleRegion region = VisibleRegion.of(obstacles, at.x(), at.y());
      counts[0] += region.met.length;
      for (int i = 0; i < region.clearWithin.length; i++) {
        float near = region.clearWithin[i];
        float far = region.hiddenBeyond[i];
        counts[1] += far < Float.POSITIVE_INFINITY ? 1 : 0;
        sums[0] += near < Float.POSITIVE_INFINITY ? near : 0;
        sums[1] += far < Float.POSITIVE_INFINITY ? far : 0;
      }
    }
    assertEquals(
        KNOWN,
        "%s %s %s %s".formatted(counts[0], counts[1], Math.round(sums[0]), Math.round(sums[1])));
  }
}
