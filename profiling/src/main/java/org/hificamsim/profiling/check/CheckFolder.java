package org.hificamsim.profiling.check;

import java.io.IOException;
import java.io.OutputStream;
import java.io.Writer;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.hificamsim.core.file.OutputFolder;

/** What a check leaves: a row per box, a row per rung and distance, and a picture. */
public final class CheckFolder {
  /** The errors, over all and by distance. */
  public static final String REALITY = "reality.csv";

  /** Every box. */
  public static final String BOXES = "boxes.csv";

  /** The errors over distance. */
  public static final String PICTURE = "reality.png";

  private static final String REALITY_COLUMNS =
      "rung,quantity,distance_from,distance_to,boxes,median_error,error_90,bias\n";
  private static final String BOX_COLUMNS =
      "frame,target,x,y,distance,foot_error,height,height_flat,height_calibration,"
          + "pip,pip_flat,pip_calibration\n";

  private CheckFolder() {}

  /**
   * Writes the files, all or none.
   *
   * @param pixels of the whole picture, which a PIP is a share of
   */
  public static void write(Path path, RealityCheck check, double pixels) throws IOException {
    try (OutputFolder folder = new OutputFolder(path)) {
      try (Writer out = folder.open(REALITY)) {
        out.write(REALITY_COLUMNS);
        write(out, check.overall());
        write(out, check.byDistance());
      }
      try (Writer out = folder.open(BOXES)) {
        out.write(BOX_COLUMNS);
        for (BoxComparison one : check.comparisons()) {
          out.write(row(one, pixels));
        }
      }
      try (OutputStream out = folder.stream(PICTURE)) {
        out.write(CheckChart.png(check));
      }
      folder.commit(List.of());
    }
  }

  private static void write(Writer out, List<ErrorSummary> summaries) throws IOException {
    for (ErrorSummary one : summaries) {
      out.write(
          String.format(
              Locale.ROOT,
              "%s,%s,%s,%s,%d,%.6f,%.6f,%.6f\n",
              one.rung(),
              one.quantity(),
              one.from(),
              one.to(),
              one.boxes(),
              one.median(),
              one.ninety(),
              one.bias()));
    }
  }

  private static String row(BoxComparison one, double pixels) {
    Sighting seen = one.sighting();
    Size flat = one.predicted().get(SizeModel.FLAT);
    Size calibrated = one.predicted().get(SizeModel.CALIBRATION);
    return String.format(
        Locale.ROOT,
        "%s,%s,%.4f,%.4f,%.4f,%.2f,%.2f,%.2f,%.2f,%.8f,%.8f,%.8f\n",
        (long) seen.frame(),
        seen.target(),
        seen.foot().getX(),
        seen.foot().getY(),
        one.distance(),
        one.footError(),
        seen.height(),
        flat.height(),
        calibrated.height(),
        seen.size().area() / pixels,
        flat.area() / pixels,
        calibrated.area() / pixels);
  }
}
