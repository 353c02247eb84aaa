package org.hificamsim.profiling.check;

/**
 * A check of files.
 *
 * @param leftOut what was not compared, in words
 * @param inWorld whether the file says where targets were; else their boxes' feet do
 * @param pixels of a whole picture
 */
public record CheckResult(RealityCheck check, String leftOut, boolean inWorld, double pixels) {
  /**
   * Reads and compares.
   *
   * @throws org.hificamsim.core.InputException when a file is wrong, or they do not belong together
   */
  public static CheckResult of(CheckSettings settings) {
    CalibratedPicture picture =
        CalibrationFile.read(settings.calibration(), settings.calibrationUnit(), settings.image());
    MotSightings boxes = MotSightings.read(settings.boxes(), picture, settings.unit().metres());
    return new CheckResult(
        RealityCheck.of(boxes.sightings(), picture.camera(), settings.body()),
        boxes.leftOut(),
        boxes.inWorld(),
        (double) picture.width() * picture.height());
  }
}
