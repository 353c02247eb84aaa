package org.hificamsim.profiling.check;

import java.io.IOException;
import java.io.OutputStream;
import java.io.Writer;
import java.nio.file.Path;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.profiling.dataset.TableLayout;

/** What a check leaves: a row per box, a row per rung and distance, and a picture. */
public final class CheckFolder {
  /** The errors, over all and by distance. */
  public static final String REALITY = "reality.csv";

  /** The errors over distance. */
  public static final String PICTURE = "reality.png";

  private static final TableLayout<ErrorSummary> SUMMARIES =
      new TableLayout<ErrorSummary>()
          .with("rung", ErrorSummary::rung)
          .with("quantity", ErrorSummary::quantity)
          .with("distance_from", ErrorSummary::from)
          .with("distance_to", ErrorSummary::to)
          .with("boxes", ErrorSummary::boxes)
          .with("median_error", one -> rounded(6, one.median()))
          .with("error_90", one -> rounded(6, one.ninety()))
          .with("bias", one -> rounded(6, one.bias()));

  private CheckFolder() {}

  private static TableLayout<BoxComparison> boxes(double pixels) {
    ToDoubleFunction<Size> pip = size -> size.area() / pixels;
    return new TableLayout<BoxComparison>()
        .with("frame", one -> (long) one.sighting().box().frame())
        .with("target", one -> one.sighting().box().target())
        .with("x", one -> rounded(4, one.sighting().foot().getX()))
        .with("y", one -> rounded(4, one.sighting().foot().getY()))
        .with("distance", one -> rounded(4, one.distance()))
        .with("foot_error", one -> rounded(2, one.footError()))
        .with("height", one -> rounded(2, one.sighting().size().height()))
        .with("height_flat", one -> rounded(2, one.predicted(SizeModel.FLAT).height()))
        .with("height_heights", one -> rounded(2, one.predicted(SizeModel.HEIGHTS).height()))
        .with(
            "height_calibration", one -> rounded(2, one.predicted(SizeModel.CALIBRATION).height()))
        .with("pip", one -> rounded(8, pip.applyAsDouble(one.sighting().size())))
        .with("pip_flat", one -> rounded(8, pip.applyAsDouble(one.predicted(SizeModel.FLAT))))
        .with("pip_heights", one -> rounded(8, pip.applyAsDouble(one.predicted(SizeModel.HEIGHTS))))
        .with(
            "pip_calibration",
            one -> rounded(8, pip.applyAsDouble(one.predicted(SizeModel.CALIBRATION))));
  }

  private static String rounded(int digits, double value) {
    return Texts.format("%." + digits + "f", value);
  }

  /** Writes the files, all or none. */
  public static void write(Path path, CheckResult result) throws IOException {
    RealityCheck check = result.check();
    try (OutputFolder folder = new OutputFolder(path)) {
      try (Writer out = folder.open(REALITY)) {
        out.write(
            SUMMARIES.csv(
                Stream.of(check.overall(), check.byDistance()).flatMap(List::stream).toList()));
      }
      try (Writer out = folder.open("boxes.csv")) {
        out.write(boxes(result.pixels()).csv(check.comparisons()));
      }
      try (OutputStream out = folder.stream(PICTURE)) {
        out.write(CheckChart.png(check));
      }
      folder.commit(List.of());
    }
  }
}
