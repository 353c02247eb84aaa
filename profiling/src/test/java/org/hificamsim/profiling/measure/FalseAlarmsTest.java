package org.hificamsim.profiling.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.hificamsim.profiling.SmallLab;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.DatasetReader;
import org.hificamsim.profiling.dataset.LabelledPhoto;
import org.hificamsim.profiling.detector.RatioTest;
import org.hificamsim.profiling.measure.Measurer.MeasureSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FalseAlarmsTest {
  private static final List<Double> WITHOUT =
      IntStream.range(0, 100).mapToObj(i -> i / 1000.0).toList();

  @TempDir Path folder;

  @Test
  void thresholdBoundsTheRateOfFalseAlarms() {
    AlarmThreshold five = AlarmThreshold.of("orb", WITHOUT, List.of(0.5, 0.094, 0.0961, 0.2), 0.05);
    assertEquals((0.094 + 0.095) / 2, five.threshold(), 0.001);
    assertTrue(five.falseAlarms() <= 0.05, five.toString());
    assertEquals(0.75, five.recall());
    AlarmThreshold none = AlarmThreshold.of("orb", WITHOUT, List.of(0.5, 0.3), 0);
    assertEquals((0.099 + 0.3) / 2, none.threshold(), 1e-12);
    assertEquals(0, none.falseAlarms());
  }

  @Test
  void uselessDetectorDetectsNothing() {
    AlarmThreshold useless = AlarmThreshold.of("orb", WITHOUT, List.of(0.01, 0.02), 0.01);
    assertTrue(useless.threshold() > 0.098);
    assertEquals(0, useless.recall());
    AlarmThreshold silent =
        AlarmThreshold.of("orb", Collections.nCopies(9, 0.0), List.of(0.4, 0.0), 0.1);
    assertEquals(0.2, silent.threshold());
    assertEquals(0.5, silent.recall());
  }

  /** The photos of the matchbox serve as photos without the ball. */
  @Test
  void photosWithoutObjectsDetermineThresholds() throws IOException {
    Dataset complete = SmallLab.render(folder);
    Files.createDirectories(folder.resolve("negatives"));
    List<LabelledPhoto> matchboxes = photosOf(complete, "matchbox");
    for (LabelledPhoto sample : matchboxes) {
      Path copy = folder.resolve("negatives").resolve(sample.file().getFileName().toString());
      Files.copy(sample.file(), copy);
    }
    Dataset read = DatasetReader.read(folder).dataset().orElseThrow();
    Dataset others =
        new Dataset(
            folder,
            read.camera(),
            photosOf(complete, "ball"),
            Map.of("ball", read.templates().get("ball")),
            read.negatives());
    List<String> detectors = List.of("orb", "orb-located", "orb-ransac");
    List<String> seen = new ArrayList<>();
    Measurer.Outcome outcome =
        new Measurer(
                others,
                new MeasureSettings(detectors, RatioTest.THESIS, PipReading.SILHOUETTE, 0.1))
            .measure(1, () -> seen.add("photo"));
    assertEquals(others.samples().size() + matchboxes.size(), seen.size());
    assertEquals(List.of(), outcome.warnings());
    Map<String, Double> thresholds = AlarmThreshold.read(folder);
    assertEquals(detectors, List.copyOf(thresholds.keySet()));
    assertTrue(thresholds.get("orb-located") < thresholds.get("orb"), thresholds.toString());
    assertTrue(thresholds.get("orb-located") > 0, thresholds.toString());
  }

  @Test
  void folderWithoutNegativesHasNoThresholds() {
    assertEquals(Map.of(), AlarmThreshold.read(folder));
  }

  private static List<LabelledPhoto> photosOf(Dataset dataset, String object) {
    return dataset.samples().stream().filter(s -> s.object().equals(object)).toList();
  }
}
