package org.hificamsim.core.detection;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Locale;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * Tests that every detection model must pass; a test class of a model implements this interface.
 */
public interface DetectionModelContract {
  /** Returns a new instance of the model. */
  DetectionModel model();

  @Test
  default void hasNameForTheCommandLine() {
    assertFalse(model().name().isBlank());
    assertEquals(model().name().toLowerCase(Locale.ROOT), model().name());
    assertFalse(model().name().contains(" ") || model().name().contains(","));
  }

  @Test
  default void hasFiniteDefaultThreshold() {
    assertTrue(Double.isFinite(model().defaultThreshold()));
  }

  @Test
  default void isFiniteInsideTheFieldOfView() {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 10_000; i++) {
      ZoomLevel zoom = zoom(random);
      double distance = i % 10 == 0 ? 0 : random.nextDouble(zoom.radius());
      double offAxis = distance == 0 ? Double.NaN : random.nextDouble(zoom.viewingAngle() / 2);
      double value = model().confidence(random.nextDouble(0.05, 2), distance, offAxis, zoom);
      assertTrue(Double.isFinite(value), value + " at " + distance + " of " + zoom);
    }
  }

  @Test
  default void holdsNoState() {
    DetectionModel shared = model();
    SplittableRandom random = new SplittableRandom(2);
    for (int i = 0; i < 1000; i++) {
      ZoomLevel zoom = zoom(random);
      double distance = random.nextDouble(zoom.radius());
      assertEquals(
          model().confidence(0.5, distance, 0.1, zoom),
          shared.confidence(0.5, distance, 0.1, zoom));
    }
  }

  @Test
  default void ignoresBearingUnlessDeclared() {
    SplittableRandom random = new SplittableRandom(3);
    for (int i = 0; i < 1000; i++) {
      ZoomLevel zoom = i % 2 == 0 ? zoom(random) : zoom(random, 2 * Math.PI);
      if (!model().dependsOnBearing(zoom)) {
        double distance = random.nextDouble(zoom.radius());
        double value = model().confidence(0.5, distance, 1, zoom);
        assertEquals(value, model().confidence(0.5, distance, random.nextDouble(0.01, 3), zoom));
        if (!model().dependsOnBearing()) {
          assertEquals(value, model().confidence(0.5, distance, 0, zoom));
          assertEquals(value, model().confidence(0.5, distance, Double.NaN, zoom));
        }
      }
    }
  }

  private static ZoomLevel zoom(SplittableRandom random) {
    return zoom(random, random.nextDouble(0.1, 2 * Math.PI));
  }

  private static ZoomLevel zoom(SplittableRandom random, double viewingAngle) {
    double widest = random.nextDouble(1, 20);
    return new ZoomLevel(random.nextDouble(0.5, widest), 0.5, widest, 3, viewingAngle);
  }
}
