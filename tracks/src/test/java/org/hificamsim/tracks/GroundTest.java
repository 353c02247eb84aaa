package org.hificamsim.tracks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.tracks.format.TrackSample;
import org.hificamsim.tracks.ground.Homography;
import org.hificamsim.tracks.ground.LocalProjection;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the conversion of pixels and degrees to metres on the ground. */
class GroundTest {
  private static final Place PLACE = new Place("file", 7, 1);

  @TempDir Path folder;

  @Test
  void convertsFootOfBox() throws IOException {
    TrackSample box = new TrackSample(PLACE, "a", 3, 10, 20, 4, 8);
    TrackSample ground = matrix("2 0.5 3\n-0.25 1.5 -7\n0.001 0.002 1.25").onGround(box);
    assertEquals(33 / 1.3, ground.x(), 1e-12);
    assertEquals(20.5 / 1.3, ground.y(), 1e-12);
    double width = Math.hypot(37 / 1.302 - 29 / 1.298, 20 / 1.302 - 21 / 1.298);
    assertEquals(width, ground.width(), 1e-12);
    assertEquals(2 * width, ground.height(), 1e-12);
  }

  @Test
  void rejectsResultsThatAreTooFar() throws IOException {
    Homography same = matrix("1 0 0\n0 1 0\n0 0 1");
    assertEquals(-1e9, same.onGround(new TrackSample(PLACE, "a", 3, 1e9, -1e9)).y());
    for (double[] far : new double[][] {{1.1e9, 0}, {0, -1.1e9}, {Double.NaN, Double.NaN}}) {
      TrackSample sample = new TrackSample(PLACE, "a", 3, far[0], far[1]);
      InputException e = assertThrows(InputException.class, () -> same.onGround(sample));
      assertEquals(
          "file:7:1: the homography converts (%1$s, %2$s) to (%1$s, %2$s), expected a place within 1e9 m"
              .formatted(far[0], far[1]),
          e.getMessage());
    }
  }

  private Homography matrix(String rows) throws IOException {
    return Homography.read(Files.writeString(folder.resolve("h.txt"), rows));
  }

  @Test
  void measuresDegreesFromOriginOrFirstPoint() {
    LocalProjection given = new LocalProjection(16, 48);
    assertEquals(16, given.longitude());
    assertEquals(48, given.latitude());
    Point converted = given.metres(PLACE, 17, 49);
    assertEquals(74_625.3, converted.x(), 0.1); // degrees of WGS84 at 48 north
    assertEquals(111_190.3, converted.y(), 0.1);
    LocalProjection first = new LocalProjection();
    assertEquals(Double.NaN, first.longitude());
    assertEquals(new Point(0, 0), first.metres(PLACE, 16, 48));
    assertEquals(converted, first.metres(PLACE, 17, 49));
  }

  @Test
  void rejectsDegreesOutsideTheGlobe() {
    LocalProjection middle = new LocalProjection(0, 0);
    assertEquals(2 * middle.metres(PLACE, 90, 0).x(), middle.metres(PLACE, 180, 90).x(), 1e-6);
    for (double[] outside : new double[][] {{180.1, 0}, {0, -90.1}, {Double.NaN, 0}}) {
      InputException e =
          assertThrows(InputException.class, () -> middle.metres(PLACE, outside[0], outside[1]));
      assertEquals(
          ("file:7:1: longitude %s and latitude %s, expected -180 to 180 and -90 to 90 degrees,"
                  + " or unit=m (of walls walls_unit=m) if they are metres")
              .formatted(outside[0], outside[1]),
          e.getMessage());
    }
  }
}
