package org.hificamsim.network.agent;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.visibility.Visibility;
import org.junit.jupiter.api.Test;

class OutsideTest {
  private final Random random = new Random(5);
  private final Outside outside = new Outside();

  @Test
  void whatIsSurelyOutsideIsNotSeen() {
    Visibility visibility =
        Visibility.asInCamSim(new Detection(new CamSimVisibilityDetection(), 0));
    int surely = 0;
    for (int i = 0; i < 100_000; i++) {
      Pose pose = Pose.of(random.nextInt(5), random.nextInt(5), random.nextDouble() * 7);
      ZoomLevel zoom = level(1 + random.nextInt(8), random.nextInt(1, 9) * Math.PI / 4);
      outside.of(pose, zoom);
      double x = place();
      double y = place();
      if (has(x, y)) {
        surely++;
        assertEquals(0, visibility.at(zoom, 1).confidence(pose, x, y, 0, 1));
      }
    }
    assertTrue(surely > 50_000, surely + " were told apart");
  }

  @Test
  void thePlaceOfTheCameraAndTheBorderAreLeftToTheExactTest() {
    outside.of(Pose.of(1, 1, 0), level(2, Math.PI / 2));
    assertFalse(has(1, 1));
    assertFalse(has(1, 3));
    assertFalse(has(2, 2));
    assertTrue(has(1, 3.000001));
    assertTrue(has(2.00001, 2));
  }

  @Test
  void ofSomePlacesTheOthersAreFoundInTheirOrder() {
    outside.of(Pose.of(0, 0, 0), level(2, Math.PI));
    double[] ahead = {3, 1, -1, 2, 1.5};
    PointGrid places = PointGrid.single(ahead.length);
    for (int place = 0; place < ahead.length; place++) {
      places.add(place, 0, ahead[place]);
    }
    places.sort();
    int[] found = new int[ahead.length];
    assertEquals(2, outside.findOthers(places, 1, 4, found));
    assertArrayEquals(new int[] {1, 3}, Arrays.copyOf(found, 2));
  }

  private boolean has(double x, double y) {
    PointGrid places = PointGrid.single(1);
    places.add(0, x, y);
    places.sort();
    return outside.findOthers(places, 0, 1, new int[1]) == 0;
  }

  private static ZoomLevel level(double radius, double angle) {
    return new ZoomLevel(radius, radius, radius, Double.NaN, angle);
  }

  /** Often a whole number, so that borders are met. */
  private double place() {
    return random.nextBoolean() ? random.nextInt(-4, 9) : random.nextDouble() * 13 - 4;
  }
}
