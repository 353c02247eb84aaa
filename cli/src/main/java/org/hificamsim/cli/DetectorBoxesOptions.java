package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
import org.hificamsim.profiling.boxes.BoxRecording;
import org.hificamsim.profiling.boxes.ExpectedFolder;
import org.hificamsim.profiling.boxes.ExpectedPeople;
import org.hificamsim.profiling.boxes.MeasuredBoxes;
import org.hificamsim.profiling.boxes.SimulatedRecording;
import org.hificamsim.profiling.check.Calibration;
import org.hificamsim.profiling.check.Calibration.Size;
import org.hificamsim.profiling.check.CheckFolder;
import org.hificamsim.profiling.fit.Reliability;
import org.hificamsim.runs.Settings;
import picocli.CommandLine.Option;

/** Checks detections against the boxes of a detector in the recording of a calibrated camera. */
final class DetectorBoxesOptions {
  @Option(names = "--boxes", paramLabel = "DET")
  private Optional<Path> boxes;

  @Option(names = "--detections", paramLabel = "A,B[@T]")
  private String detections;

  private List<ExpectedPeople> expected = List.of();
  private int withoutPlace;

  /** Simulates the recording for each detection, if there are boxes of a detector. */
  CheckFolder.FurtherFiles check(Path labels, Calibration camera, Size body) {
    boxes.ifPresent(file -> check(labels, file, camera, body));
    return folder -> {
      if (!expected.isEmpty()) {
        ExpectedFolder.write(folder, expected);
      }
    };
  }

  private void check(Path labels, Path found, Calibration camera, Size body) {
    Catalogue catalogue = Catalogue.load();
    BoxRecording.Reading reading =
        new BoxRecording.Reading(Optional.of(camera.picture()), Optional.empty(), 0);
    MeasuredBoxes measured =
        MeasuredBoxes.of(
            List.of(BoxRecording.read(labels, found, reading)), MeasuredBoxes.USUAL_OVERLAP);
    SimulatedRecording recording = new SimulatedRecording(labels, measured, camera, body);
    withoutPlace = recording.withoutPlace();
    expected =
        NameLists.detections(detections, catalogue).stream()
            .map(spec -> spec.detection(Settings.NONE))
            .map(recording::expected)
            .toList();
  }

  /** Prints how well each detection predicts the boxes of the detector. */
  void print(PrintWriter terminal) {
    if (expected.isEmpty()) {
      return;
    }
    Reliability.Part all = expected.get(0).reliability().all();
    terminal.println(
        Texts.format(
            "detector: %.3f of %d boxes found, %d without a place on the ground left out",
            all.detected(), all.count(), withoutPlace));
    int width = expected.stream().mapToInt(row -> row.detection().length()).max().orElse(0);
    String column = "%-" + Math.max(10, width) + "s";
    terminal.println(
        Texts.format(
            column + " %8s %8s %11s %8s %11s",
            "detection",
            "expects",
            "error",
            "correlation",
            "log loss",
            "worst fifth"));
    expected.forEach(row -> terminal.println(line(column, row)));
  }

  private static String line(String column, ExpectedPeople row) {
    Reliability reliability = row.reliability();
    return Texts.format(
        column + " %8.3f %+8.3f %11.2f %8.3f %11.3f",
        row.detection(),
        reliability.all().expected(),
        reliability.all().error(),
        row.correlation(),
        reliability.logLoss(),
        reliability.worstFifth());
  }
}
