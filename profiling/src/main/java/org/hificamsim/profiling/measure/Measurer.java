package org.hificamsim.profiling.measure;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.Parallel;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.Sample;
import org.hificamsim.profiling.detector.Detectors;
import org.hificamsim.profiling.detector.FeatureDetector;
import org.hificamsim.profiling.detector.Features;
import org.hificamsim.profiling.opencv.Mats;
import org.hificamsim.profiling.opencv.OpenCv;
import org.opencv.core.Core;
import org.opencv.core.Mat;
import org.opencv.imgcodecs.Imgcodecs;

/**
 * Measures every photo of a data set. At most one photo per thread is in memory, and the templates'
 * features; what has been measured survives a kill (see {@link MeasurementJournal}).
 */
public final class Measurer {
  private final Dataset dataset;
  private final MeasureSettings settings;
  private final MatchPictures pictures;

  public Measurer(Dataset dataset, MeasureSettings settings) {
    this.dataset = dataset;
    this.settings = settings;
    this.pictures = new MatchPictures(dataset.folder().resolve("matches"));
  }

  /**
   * Measures all photos and writes {@code measurements.csv}; the same on any number of threads.
   *
   * @param progress called once per photo, by any thread
   * @return how many photos an earlier, unfinished call had measured already
   * @throws InputException when a photo turns out unreadable
   */
  public int measure(int threads, Runnable progress) {
    OpenCv.load();
    try (MeasurementJournal done = MeasurementJournal.open(dataset, settings);
        Toolboxes toolboxes = new Toolboxes(settings.detectors());
        Templates templates = templates(threads, toolboxes)) {
      int resumed = done.count();
      List<Measurement> rows =
          Parallel.map(
              IntStream.range(0, dataset.samples().size()).boxed().toList(),
              threads,
              i -> {
                Measurement row =
                    done.get(i).orElseGet(() -> done.add(i, measured(i, toolboxes, templates)));
                progress.run();
                return row;
              });
      Path file = dataset.folder().resolve(MeasurementsFile.NAME);
      MeasurementsFile.write(file, settings, rows);
      done.finish();
      return resumed;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Templates templates(int threads, Toolboxes toolboxes) {
    Map<String, Map<String, Features>> all = new LinkedHashMap<>();
    List<Map.Entry<String, Path>> objects = List.copyOf(dataset.templates().entrySet());
    List<Map<String, Features>> features =
        Parallel.map(objects, threads, object -> features(object.getValue(), toolboxes));
    for (int i = 0; i < objects.size(); i++) {
      all.put(objects.get(i).getKey(), features.get(i));
    }
    return new Templates(all);
  }

  private static Map<String, Features> features(Path template, Toolboxes toolboxes) {
    try (Mats mats = new Mats()) {
      Mat grey = mats.own(picture(template));
      return toolboxes.use(
          detectors -> {
            Map<String, Features> features = new LinkedHashMap<>();
            detectors.forEach(detector -> features.put(detector.name(), detector.detect(grey)));
            return features;
          });
    }
  }

  private Measurement measured(int index, Toolboxes toolboxes, Templates templates) {
    Sample sample = dataset.samples().get(index);
    try (Mats mats = new Mats()) {
      Mat grey = mats.own(picture(sample.file()));
      Map<String, Double> confidences =
          toolboxes.use(
              detectors -> {
                Map<String, Double> values = new LinkedHashMap<>();
                for (FeatureDetector detector : detectors) {
                  values.put(detector.name(), confidence(sample, grey, detector, templates));
                }
                return values;
              });
      return new Measurement(
          sample.image(),
          sample.object(),
          sample.size(),
          sample.distance(),
          sample.focalLength(),
          pip(sample),
          confidences);
    }
  }

  private double confidence(
      Sample sample, Mat grey, FeatureDetector detector, Templates templates) {
    Features template = templates.all().get(sample.object()).get(detector.name());
    try (Features features = detector.detect(grey)) {
      if (settings.pictures().contains(sample.image())) {
        Mat close = picture(dataset.templates().get(sample.object()));
        pictures.draw(sample, detector.name(), close, template, grey, features, settings.test());
      }
      return settings.test().confidence(template, features);
    }
  }

  /** The ground truth: the share of the image that is the object's. */
  private double pip(Sample sample) {
    double pixels = (double) dataset.camera().width() * dataset.camera().height();
    Optional<Path> mask = sample.mask();
    if (settings.pip() == PipReading.RECTANGLE || mask.isEmpty()) {
      return sample.patch().area() / pixels;
    }
    try (Mats mats = new Mats()) {
      int set = Core.countNonZero(mats.own(picture(mask.get())));
      if (set == 0) {
        throw new InputException(mask.get() + ": the mask is empty, expected the object's pixels");
      }
      return set / pixels;
    }
  }

  private static Mat picture(Path file) {
    Mat picture = Imgcodecs.imread(file.toString(), Imgcodecs.IMREAD_GRAYSCALE);
    if (picture.empty()) {
      throw new InputException(file + ": cannot be decoded, expected a PNG or JPEG");
    }
    return picture;
  }

  /** The features of each object's template by detector. */
  private record Templates(Map<String, Map<String, Features>> all) implements AutoCloseable {
    @Override
    public void close() {
      all.values().forEach(features -> features.values().forEach(Features::close));
    }
  }

  /** Sets of detectors, each used by one thread at a time. */
  private static final class Toolboxes implements AutoCloseable {
    private final List<String> names;
    private final ConcurrentLinkedQueue<List<FeatureDetector>> free = new ConcurrentLinkedQueue<>();

    Toolboxes(List<String> names) {
      this.names = names;
    }

    <R> R use(java.util.function.Function<List<FeatureDetector>, R> work) {
      List<FeatureDetector> taken = free.poll();
      List<FeatureDetector> detectors =
          taken != null ? taken : names.stream().map(Detectors::create).toList();
      try {
        return work.apply(detectors);
      } finally {
        free.add(detectors);
      }
    }

    @Override
    public void close() {
      free.forEach(detectors -> detectors.forEach(FeatureDetector::close));
    }
  }
}
