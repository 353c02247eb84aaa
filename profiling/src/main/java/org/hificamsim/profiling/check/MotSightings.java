package org.hificamsim.profiling.check;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.core.InputException;
import org.hificamsim.tracks.format.MotFile;

/** The boxes of a MOT file that can be compared, and how many cannot. */
final class MotSightings {
  private final CalibratedPicture picture;
  private final List<MotFile.Row> whole = new ArrayList<>();
  private final List<Sighting> sightings = new ArrayList<>();
  private final boolean inWorld;
  private int ignored;
  private int cut;
  private int nowhere;

  /**
   * Reads a file.
   *
   * @param metres of a unit of its positions in the world
   * @throws InputException with its place, when something is wrong, or nothing can be compared
   */
  MotSightings(Path file, CalibratedPicture picture, double metres) {
    this.picture = picture;
    MotFile.read(file, this::take);
    inWorld = whole.stream().anyMatch(MotFile.Row::inWorld);
    for (MotFile.Row row : whole) {
      Vector3D foot = foot(row, metres);
      if (Double.isNaN(foot.getX())) {
        nowhere++;
      } else {
        sightings.add(new Sighting(row, foot));
      }
    }
    if (sightings.isEmpty()) {
      throw InputException.of(
          "%s: no box to compare: %s, expected whole boxes of targets on the ground"
              + " before the camera",
          file, leftOut());
    }
  }

  private void take(MotFile.Row row) {
    if (row.confidence() == 0 || row.width() <= 0 || row.height() <= 0) {
      ignored++;
    } else if (picture.cuts(row)) {
      cut++;
    } else {
      whole.add(row);
    }
  }

  /** As the file says; where it says it of no target, as the calibration has the box's foot. */
  private Vector3D foot(MotFile.Row row, double metres) {
    return inWorld
        ? new Vector3D(metres * row.x(), metres * row.y(), 0)
        : picture.camera().ground(new Calibration.Pixel(row.footX(), row.footY()));
  }

  List<Sighting> sightings() {
    return sightings;
  }

  /** Whether the file says where targets were. */
  boolean inWorld() {
    return inWorld;
  }

  /** What is not compared, in words. */
  String leftOut() {
    return "%s of confidence 0 or without size, %s cut off by the picture's border, %s without a place on the ground"
        .formatted(ignored, cut, nowhere);
  }
}
