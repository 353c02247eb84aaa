package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Ranges;
import org.hificamsim.core.Texts;
import org.hificamsim.profiling.check.Calibration;
import org.hificamsim.profiling.check.Calibration.Size;
import org.hificamsim.profiling.check.CheckFolder;
import org.hificamsim.profiling.check.ErrorSummary;
import org.hificamsim.profiling.check.MotSightings;
import org.hificamsim.profiling.check.RealityCheck;
import org.hificamsim.tracks.format.Unit;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim profile check}: compares predicted sizes of targets with a recording. */
@Command(
    name = "check",
    description = {
      "Compares predicted sizes of people with those in a recording by a calibrated camera.",
      "Writes reality.csv, boxes.csv and reality.png."
    })
final class CheckCommand implements Callable<Integer> {
  private static final double MAX_METRES = 100;

  @Parameters(paramLabel = "MOT.txt", description = "Boxes: frame,id,left,top,width,height,...")
  private Path file;

  @Option(names = "--calibration", required = true, paramLabel = "FILE")
  private Path calibration;

  @Option(names = "--assumed-height", paramLabel = "M")
  private double height;

  @Option(names = "--assumed-width", paramLabel = "M")
  private double width;

  @Option(names = "--unit", paramLabel = "m|cm|mm")
  private Unit unit;

  @Option(names = "--calibration-unit", paramLabel = "m|cm|mm")
  private Optional<Unit> calibrationUnit;

  @Mixin private ImageSizeOption image;

  @Mixin private DetectorBoxesOptions detector;

  @Option(names = "--out", paramLabel = "DIR")
  private Path out;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    Ranges.within("--assumed-height", height, Double.MIN_NORMAL, MAX_METRES);
    Ranges.within("--assumed-width", width, Double.MIN_NORMAL, MAX_METRES);
    requireLength("--unit", unit);
    calibrationUnit.ifPresent(length -> requireLength("--calibration-unit", length));
    Calibration camera = Calibration.read(calibration, calibrationUnit, image.size());
    MotSightings boxes = new MotSightings(file, camera, unit.metres());
    RealityCheck check = RealityCheck.of(boxes.sightings(), camera, new Size(width, height));
    CheckFolder.write(out, check, detector.check(file, camera, new Size(width, height)));
    print(boxes, check);
    detector.print(spec.commandLine().getOut());
    return 0;
  }

  private static void requireLength(String option, Unit unit) {
    if (Double.isNaN(unit.metres())) {
      throw InputException.of(
          "%s is %s, expected m, cm or mm", option, unit.name().toLowerCase(Locale.ROOT));
    }
  }

  private void print(MotSightings boxes, RealityCheck check) {
    PrintWriter terminal = spec.commandLine().getOut();
    terminal.printf("%s boxes; left out: %s%n", check.boxes(), boxes.leftOut());
    terminal.println(
        boxes.inWorld()
            ? "places: as the file says; half of the boxes stand within "
                + Texts.format("%.1f", check.footError())
                + " pixels of where the calibration has them"
            : "places: where boxes stand, by the calibration; the file has none");
    terminal.printf("%-12s %-8s %8s %8s %8s%n", "rung", "of", "median", "90 %", "bias");
    for (ErrorSummary errors : check.overall()) {
      terminal.printf(
          Locale.ROOT,
          "%-12s %-8s %6.1f %% %6.1f %% %+6.1f %%%n",
          errors.rung(),
          errors.quantity(),
          100 * errors.median(),
          100 * errors.ninety(),
          100 * errors.bias());
    }
    terminal.printf(
        "by distance: %s, %s%n", out.resolve(CheckFolder.REALITY), CheckFolder.PICTURE + ".png");
  }
}
