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
 * Measures every photo of a data set. At most one photo per thread is in memory, besides the
 * features of the templates. A killed measurement can be resumed (see {@link MeasurementJournal}).
 */
public final class Measurer {
  /** The number of patches in which a photo without objects is searched for each object. */
  private static final int SEARCHED_PATCHES = 8;

  private final Dataset dataset;
  private final MeasureSettings settings;

  /** Sets of detectors that no thread is using; there are at most as many sets as threads. */
  private final Queue<List<ConfidenceSource>> idleDetectors = new ConcurrentLinkedQueue<>();

  public Measurer(Dataset dataset, MeasureSettings settings) {
    this.dataset = dataset;
    this.settings = settings;
  }

  /**
   * The outcome of a measurement.
   *
   * @param resumed the number of photos that an earlier, unfinished call had measured
   * @param threads the number of threads that were used, limited by the memory
   * @param warnings each in one line
   */
  public record Outcome(int resumed, int threads, List<String> warnings) {}

  /**
   * Measures all photos and writes {@code measurements.csv}. The result does not depend on the
   * number of threads.
   *
   * @param maxThreads the largest number of threads to use
   * @throws org.hificamsim.core.InputException when a photo is unreadable or does not fit into the
   *     memory
   */
  public Outcome measure(int maxThreads, MeasureProgress watcher) {
    OpenCv.load();
    Memory neededMemory = Detectors.memoryNeed(settings.detectors());
    int threads = Memory.free().threads(maxThreads, dataset.largestPicture(), neededMemory);
    List<FeatureDetector> features = Detectors.features(settings.detectors());
    try (Templates templates = new Templates(dataset.templates(), features, threads)) {
      // Sets of an earlier call use closed templates.
      idleDetectors.clear();
      // Created here to reject an unsuitable network at once.
      idleDetectors.add(detectors(templates));
      return measure(templates, threads, watcher);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Outcome measure(Templates templates, int threads, MeasureProgress watcher)
      throws IOException {
    try (OutputFolder folder = new OutputFolder(dataset.folder());
        MeasurementJournal journal = new MeasurementJournal(dataset, settings)) {
      folder.claim(List.of(MeasurementsFile.NAME));
      int resumed = journal.count();
      watcher.resume(resumed);
      List<Measurement> rows =
          Parallel.map(
              dataset.samples(),
              threads,
              photo ->
                  journal
                      .get(photo)
                      .orElseGet(
                          () -> {
                            Measurement row = journal.add(measured(photo, templates));
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
      journal.finish();
      return new Outcome(resumed, threads, warnings);
    }
  }

  private List<Measurement> withRecall(List<Measurement> rows) {
    int[] heights = dataset.samples().stream().mapToInt(photo -> photo.patch().height()).toArray();
    List<Measurement> extended = rows;
    for (String detector : Detectors.boxes(settings.detectors())) {
      extended = Recall.with(extended, heights, detector);
    }
    return extended;
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
   * Runs all detectors on a photo, one after the other.
   *
   * @param shown whether the photo shows the subjects
   * @return the confidences of each subject, by column
   */
  private List<Map<String, Double>> confidences(
      Path file, List<Subject> subjects, boolean shown, Templates templates) {
    List<Map<String, Double>> all =
        subjects.stream().<Map<String, Double>>map(subject -> new LinkedHashMap<>()).toList();
    List<ConfidenceSource> idle = idleDetectors.poll();
    List<ConfidenceSource> detectors = idle == null ? detectors(templates) : idle;
    try (Photograph photo = new Photograph(file)) {
      for (ConfidenceSource detector : detectors) {
        List<Map<String, Double>> found =
            photo.detect(detector.name(), () -> detector.confidences(photo, subjects, shown));
        for (int i = 0; i < all.size(); i++) {
          all.get(i).putAll(found.get(i));
        }
      }
    } finally {
      idleDetectors.add(detectors);
    }
    return all;
  }

  /** Writes the thresholds; returns a warning if there are too few photos without the objects. */
  private List<String> writeThresholds(
      List<Measurement> rows,
      Templates templates,
      int threads,
      MeasureProgress watcher,
      OutputFolder folder)
      throws IOException {
    List<AlarmThreshold> thresholds = new ArrayList<>();
    double rate = settings.falseAlarms();
    List<Map<String, Double>> alarmRows = withoutObjects(templates, threads, watcher);
    for (String detector : rows.get(0).confidences().keySet()) {
      List<Double> with = rows.stream().map(row -> row.confidence(detector)).toList();
      List<Double> alarms = alarmRows.stream().map(row -> row.get(detector)).toList();
      thresholds.add(AlarmThreshold.of(detector, alarms, with, rate));
    }
    AlarmThreshold.write(folder, thresholds);
    // Patches of one photo are not independent, so that only photos and objects count.
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
   * Returns the confidences in photos without any of the objects. Each photo is searched for each
   * object, in patches that show the object in other photos.
   */
  private List<Map<String, Double>> withoutObjects(
      Templates templates, int threads, MeasureProgress watcher) {
    List<Subject> subjects =
        dataset.templates().keySet().stream().flatMap(this::subjectsElsewhere).toList();
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

  private Stream<Subject> subjectsElsewhere(String object) {
    List<LabelledPhoto> photos =
        dataset.samples().stream().filter(photo -> photo.object().equals(object)).toList();
    int patches = Math.min(SEARCHED_PATCHES, photos.size());
    return IntStream.range(0, patches)
        .mapToObj(i -> new Subject(object, photos.get(i * photos.size() / patches).patch()));
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
   * The settings of a measurement.
   *
   * @param detectors the names of the detectors, in the order of the columns
   * @param test the test that feature matches have to pass
   * @param pip the pixels that count as the object's
   * @param falseAlarms the allowed share of false alarms in photos without the object, [0, 1)
   */
  public record MeasureSettings(
      List<String> detectors, RatioTest test, PipReading pip, double falseAlarms) {
    public MeasureSettings {
      detectors = List.copyOf(detectors);
    }

    /** Returns the columns that are filled photo by photo. */
    List<String> columns() {
      return detectors.stream().map(Detectors::column).toList();
    }
  }
}
