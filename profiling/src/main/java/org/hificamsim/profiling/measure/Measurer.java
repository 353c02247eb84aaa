package org.hificamsim.profiling.measure;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.LabelledPhoto;
import org.hificamsim.profiling.detector.ConfidenceSource.Subject;
import org.hificamsim.profiling.detector.Detectors;
import org.hificamsim.profiling.detector.FeatureDetector;
import org.hificamsim.profiling.detector.Memory;
import org.hificamsim.profiling.detector.Templates;
import org.hificamsim.profiling.opencv.OpenCv;

/**
 * Measures every photo of a data set. At most one photo per thread is in memory, and the templates'
 * features; what has been measured survives a kill (see {@link MeasurementJournal}).
 */
public final class Measurer {
  private final Dataset dataset;
  private final MeasureSettings settings;

  public Measurer(Dataset dataset, MeasureSettings settings) {
    this.dataset = dataset;
    this.settings = settings;
  }

  /**
   * What became of a measurement.
   *
   * @param resumed photos that an earlier, unfinished call had measured already
   * @param threads that were used, as many as fit into the memory
   * @param warnings each in one line
   */
  public record Outcome(int resumed, int threads, List<String> warnings) {}

  /**
   * Measures all photos and writes {@code measurements.csv}; the same on any number of threads.
   *
   * @param wanted how many threads at most
   * @throws InputException when a photo turns out unreadable, or larger than the memory
   */
  public Outcome measure(int wanted, MeasureProgress watcher) {
    OpenCv.load();
    Memory need = Detectors.memoryNeed(settings.detectors());
    int threads = Memory.free().threads(wanted, dataset.largestPicture(), need);
    List<FeatureDetector> features = Detectors.features(settings.detectors());
    try (Templates templates = new Templates(dataset.templates(), features, threads)) {
      return measure(templates, new DetectorPool(settings, templates), threads, watcher);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Outcome measure(
      Templates templates, DetectorPool detectors, int threads, MeasureProgress watcher)
      throws IOException {
    try (OutputFolder folder = new OutputFolder(dataset.folder());
        MeasurementJournal done = new MeasurementJournal(dataset, settings)) {
      folder.claim(List.of(MeasurementsFile.NAME));
      int resumed = done.count();
      watcher.resume(resumed);
      List<Measurement> rows =
          Parallel.map(
              dataset.samples(),
              threads,
              photo ->
                  done.get(photo)
                      .orElseGet(
                          () -> {
                            Measurement row = done.add(measured(photo, detectors));
                            watcher.advance();
                            return row;
                          }));
      List<String> warnings = new ArrayList<>(templates.warnings());
      new UnitCheck(dataset.camera())
          .warnings(rows)
          .forEach(line -> warnings.add(dataset.folder().resolve(Dataset.TABLE) + ": " + line));
      if (!dataset.negatives().isEmpty()) {
        warnings.addAll(writeThresholds(rows, detectors, threads, watcher, folder));
      }
      write(rows, folder);
      folder.commit(List.of());
      done.finish();
      return new Outcome(resumed, threads, warnings);
    }
  }

  private Measurement measured(LabelledPhoto photo, DetectorPool detectors) {
    List<Subject> subject = List.of(new Subject(photo.object(), photo.patch()));
    Map<String, Double> found = detectors.confidences(photo.file(), subject, true).get(0);
    Map<String, Double> confidences = new LinkedHashMap<>();
    settings.columns().forEach(column -> confidences.put(column, found.get(column)));
    return new Measurement(
        photo.image(),
        photo.object(),
        photo.size(),
        photo.distance(),
        photo.focalLength(),
        settings.pip().pip(photo, dataset.camera()),
        confidences);
  }

  private void write(List<Measurement> rows, OutputFolder folder) throws IOException {
    int[] heights = dataset.samples().stream().mapToInt(s -> s.patch().height()).toArray();
    List<Measurement> all = rows;
    for (String detector : Detectors.boxes(settings.detectors())) {
      all = Recall.with(all, heights, detector);
    }
    MeasurementsFile.write(folder, settings.pip(), all);
  }

  /** Returns a warning where too few photos without the objects say anything. */
  private List<String> writeThresholds(
      List<Measurement> rows,
      DetectorPool detectors,
      int threads,
      MeasureProgress watcher,
      OutputFolder folder)
      throws IOException {
    FalseAlarms alarms = new FalseAlarms(dataset, detectors);
    List<AlarmThreshold> thresholds = new ArrayList<>();
    double rate = settings.falseAlarms();
    Map<String, List<Double>> without = alarms.confidences(threads, watcher);
    for (String detector : rows.get(0).confidences().keySet()) {
      List<Double> with = rows.stream().map(row -> row.confidence(detector)).toList();
      thresholds.add(AlarmThreshold.of(detector, without.get(detector), with, rate));
    }
    AlarmThreshold.write(folder, thresholds);
    if (alarms.looks() * rate >= 1) {
      return List.of();
    }
    return List.of(
        "%s: a rate of %s cannot be measured from %s looks at photos without the objects, expected %s or more"
            .formatted(
                dataset.folder().resolve(AlarmThreshold.FILE),
                rate,
                alarms.looks(),
                (long) Math.ceil(1 / Math.max(1e-9, rate))));
  }
}
