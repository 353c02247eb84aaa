package org.hificamsim.profiling.check;

import java.nio.file.Path;
import java.util.Optional;
import org.hificamsim.tracks.format.Unit;

/**
 * A check of a recording against a calibrated camera.
 *
 * @param leftOut what was not compared, in words
 * @param inWorld whether the file says where targets were; else their boxes' feet do
 * @param pixels of a whole picture
 */
public record CheckResult(RealityCheck check, String leftOut, boolean inWorld, double pixels) {
  /**
   * What is compared with what.
   *
   * @param boxes a MOT file
   * @param unit of its positions in the world
   * @param calibration by Tsai's method or a matrix
   * @param calibrationUnit of its world, where somebody says
   * @param image the picture's size, where somebody says
   * @param body what targets are assumed to be like, metres
   */
  public record Settings(
      Path boxes,
      Unit unit,
      Path calibration,
      Optional<Unit> calibrationUnit,
      Optional<Size> image,
      Size body) {}

  /**
   * Reads and compares.
   *
   * @throws org.hificamsim.core.InputException when a file is wrong, or they do not belong together
   */
  public static CheckResult of(Settings settings) {
    CalibratedPicture picture =
        CalibratedPicture.read(
            settings.calibration(), settings.calibrationUnit(), settings.image());
    MotSightings boxes = new MotSightings(settings.boxes(), picture, settings.unit().metres());
    return new CheckResult(
        RealityCheck.of(boxes.sightings(), picture.camera(), settings.body()),
        boxes.leftOut(),
        boxes.inWorld(),
        picture.size().area());
  }
}
