package org.hificamsim.network.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.engine.LateDetections;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

/**
 * Tests the sightings of a camera with a range of 5 m that moves past targets at x = 0, 3 and 6.
 */
class SightingsTest {
  private final World world =
      new TestScenario().camera(0, 0).target(0, 0).target(3, 0).target(6, 0).world();
  private final Sightings sightings =
      new Sightings(world, Visibility.asInCamSim(Detection.of(new CamSimVisibilityDetection()), 0));

  @Test
  void visibleTargetsKeepOrderOfAppearance() {
    assertEquals(List.of(1, 2), seenFrom(7));
    assertEquals(List.of(1, 2, 0), seenFrom(3));
    assertEquals(List.of(1, 0), seenFrom(0));
    assertEquals(List.of(1, 0, 2), seenFrom(3));
  }

  @Test
  void forgottenTargetComesLastWhenSeenAgain() {
    assertEquals(List.of(0, 1), seenFrom(0));
    assertTrue(sightings.sees(0, 0));
    sightings.forget(0, 0);
    assertFalse(sightings.sees(0, 0));
    assertEquals(List.of(1, 0), seenFrom(0));
  }

  /** Returns the targets that the camera sees from a position near the line of targets. */
  private List<Integer> seenFrom(double x) {
    world.moveCamera(0, x + 0.5, 1);
    sightings.look(0, new int[1], new int[3], LateDetections.NONE);
    return IntStream.range(0, sightings.visibleCount(0))
        .mapToObj(index -> sightings.visible(0, index))
        .toList();
  }
}
