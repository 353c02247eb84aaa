package org.hificamsim.profiling.trial;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FitSettings;
import org.hificamsim.profiling.fit.FitSettings.SupportVectorSettings;
import org.hificamsim.profiling.fit.FitSettings.SymbolicSettings;
import org.hificamsim.profiling.fit.FittedModel;
import org.hificamsim.profiling.fit.Fitting;
import org.hificamsim.profiling.fit.Photos;
import org.hificamsim.profiling.measure.Measurement;
import org.hificamsim.profiling.trial.Trials.Covered;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The simulator, asked about photos whose truth is known. */
class TrialRunTest {
  private static final double THRESHOLD = 0.3;
  private static final double ALPHA = 0.05;

  private static FitResult scattered;

  @TempDir Path folder;

  @BeforeAll
  static void fitScattered() {
    scattered = fit(curve().scatter(0.1, 0.05).take(2));
  }

  /** A curve through all photos: nothing is left to disagree about but rounding. */
  @Test
  void aDetectorAsTheModelSaysIsDetectedAsMeasured() {
    Trials trials = trials(curve().take(1));
    assertEquals("d-pinhole", trials.model().name());
    assertEquals(THRESHOLD, trials.threshold());
    assertEquals(1, trials.share(Trial::agrees));
    assertTrue(trials.share(Trial::measured) > 0.2 && trials.share(Trial::measured) < 0.8);
    assertEquals(trials.measured(), trials.simulated());
    assertEquals(1, trials.balanced());
    assertTrue(trials.measured().once() > trials.measured().more());
  }

  @Test
  void theSimulatorSaysWhatTheModelWithoutTheObjectSays() {
    Trials trials = TrialRun.of(FittedModel.of(scattered, "d").get(0));
    List<String> objects =
        trials.photos().stream().map(one -> one.photo().object()).distinct().toList();
    for (Trial one : trials.photos()) {
      HiFiDetection without = trials.model().without(objects.indexOf(one.photo().object()));
      boolean detects = confidence(without, one.photo()) >= THRESHOLD;
      assertEquals(detects, one.simulated(), one.toString());
      assertEquals(one.photo().confidence("d") >= THRESHOLD, one.measured(), one.toString());
    }
  }

  /** Nobody who has not seen the object knows that it is never found. */
  @Test
  void anObjectThatIsNeverFoundIsInvented() {
    UnaryOperator<Measurement> blank = m -> m.object().equals("o6") ? Photos.with(m, 0) : m;
    Trials trials = trials(curve().take(1).stream().map(blank).toList());
    double invented = trials.share(Trial::invented);
    assertTrue(invented > 0.02, "" + invented);
    assertTrue(
        trials.photos().stream()
            .filter(Trial::invented)
            .allMatch(one -> one.photo().object().equals("o6")));
    assertTrue(trials.leastOfObject() < 0.9, "" + trials.leastOfObject());
    assertTrue(trials.simulated().once() > trials.measured().once() + 0.01);
    assertTrue(trials.balanced() < 1);
  }

  /**
   * By chance the share of the detected is right though no single draw is known. Photos count false
   * alarms, the simulator does not.
   */
  @Test
  void chanceExpectsAsMuchAsIsMeasured() {
    Trials trials = trials(curve().scatter(0, 0.12).take(3));
    Covered expected = trials.byChance().orElseThrow();
    double k = trials.measuredByChance().meanK();
    assertEquals(k, expected.meanK() + ALPHA * (TrialRun.CAMERAS - expected.meanK()), 0.1);
    double mean = trials.photos().stream().mapToDouble(Trial::chance).average().orElseThrow();
    assertEquals(trials.share(Trial::measuredByChance), mean + ALPHA * (1 - mean), 0.02);
  }

  private void write(List<Trials> trials) throws IOException {
    try (OutputFolder files = new OutputFolder(folder)) {
      Trials.write(files, trials);
      files.commit(List.of());
    }
  }

  @Test
  void everyPhotoIsARowAndAsManyThreadsAsThereAreChangeNothing() throws IOException {
    List<Trials> trials = TrialRun.all(scattered, 1);
    write(trials);
    String one = Files.readString(folder.resolve(Trials.FILE));
    write(TrialRun.all(scattered, 2));
    assertEquals(one, Files.readString(folder.resolve(Trials.FILE)));
    assertEquals(1 + scattered.measurements().size(), one.lines().count());
    assertTrue(
        one.startsWith(
            "detector,model,image,object,size_m,distance_m,focal_length_m,confidence,threshold,"
                + "detected,simulated,chance\n"));
    assertTrue(
        trials
            .get(0)
            .sentence()
            .matches("In the simulation d-pinhole agrees .* before up to 3 cameras, .*"),
        trials.get(0).sentence());
  }

  private static double confidence(HiFiDetection model, Measurement photo) {
    double angle = 2 * StrictMath.atan(0.0224 / (2 * photo.focalLength()));
    ZoomLevel zoom = new ZoomLevel(99, 99, 99, Double.NaN, angle, angle, 0);
    return model.confidence(photo.size(), photo.distance(), 0, zoom);
  }

  private static double g(double share) {
    return 0.05 + 0.7 * (1 - Math.exp(-share / 0.01));
  }

  private static Photos curve() {
    return new Photos().detector("d", TrialRunTest::g).scatter(0, 0);
  }

  private static Trials trials(List<Measurement> photos) {
    FitResult result = fit(photos);
    return TrialRun.of(FittedModel.of(result, "d").get(0));
  }

  private static FitResult fit(List<Measurement> photos) {
    FitSettings settings =
        new FitSettings(
            5,
            0,
            new SymbolicSettings(50, 1, 0.001, 0, 1),
            SupportVectorSettings.THESIS,
            Optional.of("saturating-exponential"),
            Map.of("d", THRESHOLD));
    return new Fitting(settings).fit(Photos.CAMERA, photos, 2);
  }
}
