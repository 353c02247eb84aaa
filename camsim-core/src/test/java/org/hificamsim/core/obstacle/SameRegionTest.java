package org.hificamsim.core.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A region knows as much before it has to look at obstacles as it did: that alone makes it fast.
 * Who changes what it knows sees here what that comes to.
 */
class SameRegionTest {
  private static final int PLACES = 200;

  /**
   * @param entries what is met in all sectors of all places
   * @param hidden how many sectors hide what is far away
   * @param touched square metres in which sectors touch nothing, where they touch anything
   * @param behind square metres up to where they hide everything
   */
  @ParameterizedTest
  @CsvSource({"Infinity, 9174, 4635, 22516, 25159", "3, 4914, 2554, 639, 2182"})
  void ofFixedPlaces(double reach, int entries, int hidden, long touched, long behind) {
    int[] counts = new int[2];
    double[] sums = new double[2];
    for (int seed = 0; seed < PLACES; seed++) {
      RandomPlace place = new RandomPlace(seed);
      Obstacles obstacles = place.obstacles(10, false);
      Point at = place.point();
      RegionSweep sweep = new RegionSweep(obstacles, at.x(), at.y(), reach);
      counts[0] += sweep.met().length;
      float[] limits = sweep.limits();
      for (int i = 0; i < limits.length; i += VisibleRegion.LIMITS) {
        float near = limits[i + VisibleRegion.TOUCHED];
        float far = limits[i + VisibleRegion.HIDDEN];
        counts[1] += far < Float.POSITIVE_INFINITY ? 1 : 0;
        sums[0] += near < Float.POSITIVE_INFINITY ? near : 0;
        sums[1] += far < Float.POSITIVE_INFINITY ? far : 0;
      }
    }
    assertEquals(
        "%s %s %s %s".formatted(entries, hidden, touched, behind),
        "%s %s %s %s".formatted(counts[0], counts[1], Math.round(sums[0]), Math.round(sums[1])));
  }
}
