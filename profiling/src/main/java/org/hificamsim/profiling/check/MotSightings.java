package org.hificamsim.profiling.check;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.check.Calibration.Pixel;
import org.hificamsim.profiling.check.Calibration.Size;
import org.hificamsim.tracks.format.MotFile;

/**
 * The boxes of a MOT file that can be compared with predictions, and the numbers of those that
 * cannot.
 */
public final class MotSightings {
  /**
   * A target's box in the picture, and its position on the ground.
   *
   * @param foot the position on the ground, in metres
   */
  public record Sighting(MotFile.Row box, Vector3D foot) {
    Size size() {
      return new Size(box.width(), box.height());
    }

    /** Returns the middle of the lower edge of the box. */
    Pixel footPixel() {
      return new Pixel(box.footX(), box.footY());
    }
  }

  private final Calibration camera;
  private final List<MotFile.Row> uncutBoxes = new ArrayList<>();
  private final List<Sighting> sightings = new ArrayList<>();
  private final boolean inWorld;
  private int ignored;
  private int cutOff;
  private int withoutPlace;

  /**
   * Reads a file.
   *
   * @param metresPerUnit the length of a unit of its world positions, in metres
   * @throws InputException if the file is wrong, with line and column, or has no box to compare
   */
  public MotSightings(Path file, Calibration camera, double metresPerUnit) {
    this.camera = camera;
    MotFile.read(file, this::classify);
    inWorld = uncutBoxes.stream().anyMatch(MotFile.Row::isInWorld);
    for (MotFile.Row row : uncutBoxes) {
      Vector3D foot = foot(row, metresPerUnit);
      if (Double.isNaN(foot.getX())) {
        withoutPlace++;
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

  private void classify(MotFile.Row row) {
    if (row.confidence() == 0 || row.width() <= 0 || row.height() <= 0) {
      ignored++;
    } else if (isCut(row)) {
      cutOff++;
    } else {
      uncutBoxes.add(row);
    }
  }

  /** Whether the border of the picture may cut the box off. */
  private boolean isCut(MotFile.Row box) {
    return box.left() <= 0
        || box.top() <= 0
        || box.left() + box.width() >= camera.picture().width()
        || box.top() + box.height() >= camera.picture().height();
  }

  /**
   * Returns the position in the file, or, if the file has none at all, the calibrated ground point
   * at the foot of the box.
   */
  private Vector3D foot(MotFile.Row row, double metres) {
    return inWorld
        ? new Vector3D(metres * row.x(), metres * row.y(), 0)
        : camera.ground(new Pixel(row.footX(), row.footY()));
  }

  /** The boxes that can be compared. */
  public List<Sighting> sightings() {
    return sightings;
  }

  /** Whether the file has world positions of targets. */
  public boolean inWorld() {
    return inWorld;
  }

  /** Describes the boxes that are not compared. */
  public String leftOut() {
    return "%s of confidence 0 or without size, %s cut off by the picture's border, %s without a place on the ground"
        .formatted(ignored, cutOff, withoutPlace);
  }
}
