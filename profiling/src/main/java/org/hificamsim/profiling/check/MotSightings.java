package org.hificamsim.profiling.check;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.check.Calibration.Pixel;
import org.hificamsim.profiling.check.Calibration.Size;
import org.hificamsim.tracks.format.MotFile;

/** The boxes of a MOT file that can be compared, and how many cannot. */
public final class MotSightings {
  /**
   * A target as it was seen: its box in the picture, and where it stood.
   *
   * @param foot its place on the ground, metres
   */
  public record Sighting(MotFile.Row box, Vector3D foot) {
    Size size() {
      return new Size(box.width(), box.height());
    }

    /** Where the box stands. */
    Pixel stand() {
      return new Pixel(box.footX(), box.footY());
    }
  }

  private final Calibration camera;
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
  public MotSightings(Path file, Calibration camera, double metres) {
    this.camera = camera;
    MotFile.read(file, this::take);
    inWorld = whole.stream().anyMatch(MotFile.Row::isInWorld);
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
    } else if (isCut(row)) {
      cut++;
    } else {
      whole.add(row);
    }
  }

  /** Whether the picture's border may have cut a box off. */
  private boolean isCut(MotFile.Row box) {
    return box.left() <= 0
        || box.top() <= 0
        || box.left() + box.width() >= camera.picture().width()
        || box.top() + box.height() >= camera.picture().height();
  }

  /** As the file says; where it says it of no target, as the calibration has the box's foot. */
  private Vector3D foot(MotFile.Row row, double metres) {
    return inWorld
        ? new Vector3D(metres * row.x(), metres * row.y(), 0)
        : camera.ground(new Pixel(row.footX(), row.footY()));
  }

  public List<Sighting> sightings() {
    return sightings;
  }

  /** Whether the file says where targets were. */
  public boolean inWorld() {
    return inWorld;
  }

  /** What is not compared, in words. */
  public String leftOut() {
    return "%s of confidence 0 or without size, %s cut off by the picture's border, %s without a place on the ground"
        .formatted(ignored, cut, nowhere);
  }
}
