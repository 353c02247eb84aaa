package org.hificamsim.core.scenario.spec;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ZoneTest {
  private static Zone zone(Double facing, Double tolerance, Double maxDepression) {
    return new Zone(
        "door", Zone.Shape.FIELD, List.of(), null, 1, 1.0, facing, tolerance, maxDepression);
  }

  @ParameterizedTest
  @CsvSource({
    // facing, tolerance, east, north, seen
    "0, 30, 0, 5, true",
    "0, 30, 0, -5, false",
    "90, 30, 5, 2.8, true",
    "90, 30, 5, 3, false",
    "-170, 30, 0.5, -5, true", // across 180 degrees
    "190, 30, 0.5, -5, true",
    "190, 180, 0.5, 5, true"
  })
  void countsCamerasInFrontOfFaces(
      double facing, double tolerance, double east, double north, boolean seen) {
    assertEquals(seen, zone(facing, tolerance, null).showsFace(east, north, Double.NaN));
  }

  @ParameterizedTest
  @CsvSource({
    "20, 3, 1, true", // 18.4 degrees
    "20, 3, 1.2, false", // 21.8 degrees
    "20, 3, -9, true", // from below
    "90, 0, 5, true"
  })
  void countsCamerasThatAreNotTooSteep(
      double maxDepression, double distance, double above, boolean seen) {
    assertEquals(seen, zone(null, null, maxDepression).showsFace(distance, 0, above));
  }

  @Test
  void usualToleranceIsThirtyDegrees() {
    Zone east = zone(90.0, null, null);
    assertTrue(east.showsFace(5, 2.8, 0) && !east.showsFace(5, 3, 0));
  }

  @Test
  void countsAllCamerasUnlessFacesAreDemanded() {
    assertTrue(Zone.ofField().showsFace(0, -1, 1000));
    assertTrue(!Zone.ofField().asksForFaces() && zone(null, null, 15.0).asksForFaces());
  }

  @Test
  void rejectsToleranceWithoutFacing() {
    assertThrows(IllegalArgumentException.class, () -> zone(null, 20.0, null));
  }
}
