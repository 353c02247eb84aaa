package org.hificamsim.profiling.measure;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.LabelledPhoto;
import org.hificamsim.profiling.detector.ConfidenceSource.Look;
import org.hificamsim.profiling.detector.Detectors;
import org.hificamsim.profiling.detector.Subject;
import org.hificamsim.profiling.opencv.OpenCv;

/**
 * Measures every photo of a data set. At most one photo per thread is in memory, and the templates'
 * features; what has been measured survives a kill (see {@link MeasurementJournal}).
 */
public final class Measurer {
  private final Dataset dataset;
  private final MeasureSettings settings;
  private final PipCount pip;

  public Measurer(Dataset dataset, MeasureSettings settings) {
    this.dataset = dataset;
    this.settings = settings;
    this.pip = new PipCount(dataset.camera(), settings.pip());
  }

  /**
   * Measures all photos and writes {@code measurements.csv}; the same on any number of threads.
   *
   * @param wanted how many threads at most
   * @throws InputException when a photo turns out unreadable, or larger than the memory
   */
  public MeasureResult measure(int wanted, MeasureProgress watcher) {
    OpenCv.load();
    int threads = threads(wanted);
    List<String> extractors = Detectors.extractors(settings.detectors());
    try (Templates templates = Templates.of(dataset, extractors, threads);
        DetectorPool detectors = new DetectorPool(settings, templates);
        MeasurementJournal done = MeasurementJournal.open(dataset, settings)) {
      int resumed = done.count();
      watcher.resumed(resumed);
      List<Measurement> rows =
          Parallel.map(
              IntStream.range(0, dataset.samples().size()).boxed().toList(),
              threads,
              i ->
                  done.get(i)
                      .orElseGet(
                          () -> {
                            Measurement row = done.add(i, measured(i, detectors));
                            watcher.measured();
                            return row;
                          }));
      List<String> warnings = warnings(templates, rows);
      if (!dataset.negatives().isEmpty()) {
        warnings.addAll(writeThresholds(rows, detectors, threads, watcher));
      }
      write(rows);
      done.finish();
      return new MeasureResult(resumed, threads, warnings);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private int threads(int wanted) {
    return MemoryBudget.now()
        .threads(wanted, dataset.largestPicture(), Detectors.memoryNeed(settings.detectors()));
  }

  private Measurement measured(int index, DetectorPool detectors) {
    LabelledPhoto sample = dataset.samples().get(index);
    List<Subject> subject = List.of(new Subject(sample.object(), sample.patch()));
    Map<String, Double> confidences =
        detectors.confidences(sample.file(), subject, Look::confidences).get(0);
    return new Measurement(
        sample.image(),
        sample.object(),
        sample.size(),
        sample.distance(),
        sample.focalLength(),
        pip.of(sample),
        MeasurementJournal.columns(settings).ordered(confidences));
  }

  private void write(List<Measurement> rows) throws IOException {
    int[] heights = dataset.samples().stream().mapToInt(s -> s.patch().height()).toArray();
    List<Measurement> all = rows;
    for (String detector : Detectors.boxes(settings.detectors())) {
      all = Recall.with(all, heights, detector);
    }
    MeasurementsFile.write(
        dataset.folder().resolve(MeasurementsFile.NAME),
        MeasurementColumns.of(settings.pip(), all),
        all);
  }

  private List<String> writeThresholds(
      List<Measurement> rows, DetectorPool detectors, int threads, MeasureProgress watcher)
      throws IOException {
    FalseAlarms alarms = new FalseAlarms(dataset, detectors);
    Map<String, AlarmThreshold> thresholds = new LinkedHashMap<>();
    Map<String, List<Double>> without = alarms.confidences(threads, watcher);
    for (String detector : rows.get(0).confidences().keySet()) {
      List<Double> with = rows.stream().map(row -> row.confidence(detector)).toList();
      thresholds.put(
          detector, AlarmThreshold.of(without.get(detector), with, settings.falseAlarms()));
    }
    Path file = dataset.folder().resolve(ThresholdsFile.NAME);
    ThresholdsFile.write(file, thresholds);
    return alarms.looks() * settings.falseAlarms() >= 1
        ? List.of()
        : List.of(tooFew(file, alarms.looks()));
  }

  private String tooFew(Path file, int looks) {
    return "%s: a rate of %s cannot be told from %s looks at photos without the objects, expected %s or more"
        .formatted(
            file,
            settings.falseAlarms(),
            looks,
            (long) Math.ceil(1 / Math.max(1e-9, settings.falseAlarms())));
  }

  private List<String> warnings(Templates templates, List<Measurement> rows) {
    List<String> warnings = new ArrayList<>(templates.warnings());
    new UnitCheck(dataset.camera())
        .warnings(rows)
        .forEach(line -> warnings.add(dataset.folder().resolve(Dataset.TABLE) + ": " + line));
    return warnings;
  }
}
