package org.hificamsim.core.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.junit.jupiter.api.Test;

/** Tests the views of optics. */
class ViewSetTest {
  private static OpticsSpec optics(OpticsLaw law, Optional<Double> reach) {
    return optics(law, reach, List.of(10.0, 40.0));
  }

  private static OpticsSpec optics(OpticsLaw law, Optional<Double> reach, List<Double> angles) {
    return new OpticsSpec("ptz")
        .with(OpticsSpec.LAW, law)
        .with(OpticsSpec.PIXELS, 640)
        .with(OpticsSpec.ANGLES_OF_VIEW, angles)
        .with(OpticsSpec.REACH, reach)
        .with(OpticsSpec.PANS, List.of(-60.0, 10.0, 60.0));
  }

  private static List<Double> radii(ViewSet views) {
    return views.zooms().stream().map(ZoomLevel::radius).toList();
  }

  @Test
  void ordersViewsByPanAngleThenLevel() {
    ViewSet views = ViewSet.ofLens(optics(OpticsLaw.PINHOLE, Optional.empty()), 9, 3);
    assertEquals(6, views.count());
    for (int view = 0; view < 6; view++) {
      assertEquals(Math.toRadians(List.of(-60.0, 10.0, 60.0).get(view / 2)), views.pan(view));
      ZoomLevel zoom = views.zoom(view);
      assertEquals(Math.toRadians(view % 2 == 0 ? 10 : 40), zoom.viewingAngle());
      assertEquals(zoom.viewingAngle(), zoom.angleOfView());
      assertEquals(640, zoom.pixels());
      assertEquals(3, zoom.mountHeight());
    }
    assertEquals(3, views.home(), "the widest, 10 degrees off");
  }

  @Test
  void lensWithoutReachTakesReachOfCamera() {
    Stream.of(OpticsLaw.PINHOLE, OpticsLaw.CONSTANT_AREA)
        .forEach(
            law ->
                assertEquals(
                    ViewSet.ofLens(optics(law, Optional.of(9.0)), 50, Double.NaN),
                    ViewSet.ofLens(optics(law, Optional.empty()), 9, Double.NaN)));
  }

  @Test
  void narrowerSectorOfConstantAreaReachesFarther() {
    ViewSet views = ViewSet.ofLens(optics(OpticsLaw.CONSTANT_AREA, Optional.of(8.0)), 0, 0);
    assertEquals(List.of(8.0, 4.0), radii(views));
    assertEquals(4, views.zoom(0).narrowestRadius());
    assertEquals(8, views.zoom(1).widestRadius());
    ViewSet pinhole = ViewSet.ofLens(optics(OpticsLaw.PINHOLE, Optional.of(8.0)), 0, 0);
    assertEquals(List.of(8.0, 8.0), radii(pinhole));
  }

  @Test
  void adjacentViewsDifferByOneStep() {
    List<Double> angles = List.of(10.0, 20.0, 40.0);
    ViewSet views = ViewSet.ofLens(optics(OpticsLaw.PINHOLE, Optional.empty(), angles), 9, 3);
    assertTrue(views.isNextTo(4, 4) && views.isNextTo(0, 4) && views.isNextTo(7, 5));
    assertFalse(views.isNextTo(0, 2), "two levels");
    assertFalse(views.isNextTo(0, 6), "two pan angles");
    assertFalse(views.isNextTo(2, 3), "two levels, though the numbers are next to each other");
  }
}
