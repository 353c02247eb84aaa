package org.hificamsim.profiling.measure;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.LabelledPhoto;
import org.hificamsim.profiling.detector.ConfidenceSource;
import org.hificamsim.profiling.detector.ConfidenceSource.Subject;
import org.hificamsim.profiling.detector.Detectors;
import org.hificamsim.profiling.detector.FeatureDetector;
import org.hificamsim.profiling.detector.Memory;
import org.hificamsim.profiling.detector.Photograph;
import org.hificamsim.profiling.detector.RatioTest;
import org.hificamsim.profiling.detector.Templates;
import org.hificamsim.profiling.opencv.OpenCv;

/**
 * Measures every photo of a data set. At most one photo per thread is in memory, and the templates'
 * features; what has been measured survives a kill (see {@link MeasurementJournal}).
 */
public final class Measurer {
  private static final int PLACES = 8;

  private final Dataset dataset;
  private final MeasureSettings settings;

  /** Sets of detectors that no thread uses just now: there are as many as threads at the most. */
  private final Queue<List<ConfidenceSource>> free = new ConcurrentLinkedQueue<>();

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
   * @throws org.hificamsim.core.InputException when a photo turns out unreadable, or larger than
   *     the memory
   */
  public Outcome measure(int wanted, MeasureProgress watcher) {
    OpenCv.load();
    Memory need = Detectors.memoryNeed(settings.detectors());
    int threads = Memory.free().threads(wanted, dataset.largestPicture(), need);
    List<FeatureDetector> features = Detectors.features(settings.detectors());
    try (Templates templates = new Templates(dataset.templates(), features, threads)) {
      free.clear(); // those of an earlier call have its templates
      free.add(detectors(templates)); // a file that is no detector's is refused at once
      return measure(templates, threads, watcher);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Outcome measure(Templates templates, int threads, MeasureProgress watcher)
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
                            Measurement row = done.add(measured(photo, templates));
                            watcher.advance();
                            return row;
                          }));
      List<String> warnings = new ArrayList<>(templates.warnings());
      new UnitCheck(dataset.camera())
          .warnings(rows)
          .forEach(line -> warnings.add(dataset.folder().resolve(Dataset.TABLE) + ": " + line));
      if (!dataset.negatives().isEmpty()) {
        warnings.addAll(writeThresholds(rows, templates, threads, watcher, folder));
      }
      MeasurementsFile.write(folder, settings.pip(), withRecall(rows));
      folder.commit(List.of());
      done.finish();
      return new Outcome(resumed, threads, warnings);
    }
  }

  private List<Measurement> withRecall(List<Measurement> rows) {
    int[] heights = dataset.samples().stream().mapToInt(s -> s.patch().height()).toArray();
    List<Measurement> all = rows;
    for (String detector : Detectors.boxes(settings.detectors())) {
      all = Recall.with(all, heights, detector);
    }
    return all;
  }

  private List<ConfidenceSource> detectors(Templates templates) {
    return Detectors.sources(settings.detectors(), settings.test(), templates);
  }

  private Measurement measured(LabelledPhoto photo, Templates templates) {
    List<Subject> subject = List.of(new Subject(photo.object(), photo.patch()));
    Map<String, Double> found = confidences(photo.file(), subject, true, templates).get(0);
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

  /**
   * Looks at a photo with one detector after the other.
   *
   * @param shown whether the photo has the subjects
   * @return the confidences of each subject, by column
   */
  private List<Map<String, Double>> confidences(
      Path file, List<Subject> subjects, boolean shown, Templates templates) {
    List<Map<String, Double>> all =
        subjects.stream().<Map<String, Double>>map(subject -> new LinkedHashMap<>()).toList();
    List<ConfidenceSource> kept = free.poll();
    List<ConfidenceSource> detectors = kept == null ? detectors(templates) : kept;
    try (Photograph photo = new Photograph(file)) {
      for (ConfidenceSource detector : detectors) {
        List<Map<String, Double>> found =
            photo.lookedAt(detector.name(), () -> detector.confidences(photo, subjects, shown));
        for (int i = 0; i < all.size(); i++) {
          all.get(i).putAll(found.get(i));
        }
      }
    } finally {
      free.add(detectors);
    }
    return all;
  }

  /** Returns a warning where too few photos without the objects say anything. */
  private List<String> writeThresholds(
      List<Measurement> rows,
      Templates templates,
      int threads,
      MeasureProgress watcher,
      OutputFolder folder)
      throws IOException {
    List<AlarmThreshold> thresholds = new ArrayList<>();
    double rate = settings.falseAlarms();
    List<Map<String, Double>> without = withoutObjects(templates, threads, watcher);
    for (String detector : rows.get(0).confidences().keySet()) {
      List<Double> with = rows.stream().map(row -> row.confidence(detector)).toList();
      List<Double> alarms = without.stream().map(row -> row.get(detector)).toList();
      thresholds.add(AlarmThreshold.of(detector, alarms, with, rate));
    }
    AlarmThreshold.write(folder, thresholds);
    // Places in one photo are not independent.
    int looks = dataset.negatives().size() * dataset.templates().size();
    if (looks * rate >= 1) {
      return List.of();
    }
    return List.of(
        "%s: a rate of %s cannot be measured from %s looks at photos without the objects, expected %s or more"
            .formatted(
                dataset.folder().resolve(AlarmThreshold.FILE),
                rate,
                looks,
                (long) Math.ceil(1 / Math.max(1e-9, rate))));
  }

  /**
   * What the detectors make of photos without any of the objects. Each photo is asked for each
   * object, at places and in sizes that the object has in the other photos.
   */
  private List<Map<String, Double>> withoutObjects(
      Templates templates, int threads, MeasureProgress watcher) {
    List<Subject> subjects =
        dataset.templates().keySet().stream().flatMap(this::elsewhere).toList();
    return Parallel.map(
            dataset.negatives(),
            threads,
            photo -> {
              List<Map<String, Double>> seen = confidences(photo, subjects, false, templates);
              watcher.advance();
              return seen;
            })
        .stream()
        .flatMap(List::stream)
        .toList();
  }

  private Stream<Subject> elsewhere(String object) {
    List<LabelledPhoto> of =
        dataset.samples().stream().filter(s -> s.object().equals(object)).toList();
    int places = Math.min(PLACES, of.size());
    return IntStream.range(0, places)
        .mapToObj(i -> new Subject(object, of.get(i * of.size() / places).patch()));
  }

  /** Receives the progress of a measurement; may be called from any thread. */
  @FunctionalInterface
  public interface MeasureProgress {
    /** Called after each photo. */
    void advance();

    /** Called first, with the number of photos that an earlier call has measured. */
    default void resume(long photos) {}
  }

  /**
   * How photos are measured.
   *
   * @param detectors as they are asked for, in the order of the columns
   * @param test which matches count
   * @param pip which pixels are the object's
   * @param falseAlarms the share of the photos without the object that may be taken for it, [0, 1)
   */
  public record MeasureSettings(
      List<String> detectors, RatioTest test, PipReading pip, double falseAlarms) {
    public MeasureSettings {
      detectors = List.copyOf(detectors);
    }

    /** The columns that are filled photo by photo. */
    List<String> columns() {
      return detectors.stream().map(Detectors::column).toList();
    }
  }
}
