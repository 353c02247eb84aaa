package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.Ranges;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.DatasetReader;
import org.hificamsim.profiling.detector.Detectors;
import org.hificamsim.profiling.detector.RatioTest;
import org.hificamsim.profiling.measure.MatchPictures;
import org.hificamsim.profiling.measure.MeasurementsFile;
import org.hificamsim.profiling.measure.Measurer;
import org.hificamsim.profiling.measure.Measurer.MeasureSettings;
import org.hificamsim.profiling.measure.PipReading;
import org.hificamsim.profiling.opencv.OpenCv;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim profile measure}: measures PIP and confidences of every photo. */
@Command(
    name = "measure",
    description = "Measures every photo of a data set and writes measurements.csv; resumable.")
final class MeasureCommand implements Callable<Integer> {
  @Parameters(paramLabel = "DIR", description = "The data set's folder.")
  private Path folder;

  @Option(names = "--detectors", paramLabel = "A,B", split = ",")
  private List<String> detectors;

  @Option(names = "--metric", paramLabel = "euclidean|hamming")
  private RatioTest.Metric metric;

  @Option(names = "--ratio", paramLabel = "R")
  private double ratio;

  @Option(names = "--pip", paramLabel = "silhouette|rectangle")
  private PipReading pip;

  @Option(names = "--false-alarms", paramLabel = "P")
  private double falseAlarms;

  @Option(names = "--picture", paramLabel = "IMAGE")
  private Set<String> pictures = new LinkedHashSet<>();

  @Mixin private ThreadsOption threads;

  @Mixin private Screen screen;

  @Override
  public Integer call() throws IOException {
    MeasureSettings settings = settings();
    int count = threads.count();
    PrintWriter err = screen.errors();
    DatasetReader.Reading reading = DatasetReader.read(folder);
    reading.problems().forEach(problem -> err.println("error: " + problem));
    if (reading.dataset().isEmpty()) {
      err.flush();
      return Main.BAD_INPUT;
    }
    measure(reading.dataset().get(), settings, count);
    return 0;
  }

  private void measure(Dataset dataset, MeasureSettings settings, int count) throws IOException {
    for (String picture : pictures) {
      if (dataset.samples().stream().noneMatch(sample -> sample.image().equals(picture))) {
        throw InputException.of(
            "--picture is '%s', expected an image of %s", picture, Dataset.TABLE);
      }
    }
    if (pictures.isEmpty() || !Files.exists(folder.resolve(MeasurementsFile.NAME))) {
      measureAll(dataset, settings, count);
    }
    if (!pictures.isEmpty()) {
      int drawn = new MatchPictures(dataset, settings).draw(pictures);
      screen.say("%s drawn: %s", drawn, folder.resolve(MatchPictures.FOLDER));
    }
  }

  private void measureAll(Dataset dataset, MeasureSettings settings, int count) {
    int photos = dataset.samples().size();
    Measurer.Outcome outcome;
    try (Progress progress = screen.progress("", " photos", photos + dataset.negatives().size())) {
      outcome = new Measurer(dataset, settings).measure(count, progress);
    }
    if (outcome.threads() < count) {
      screen.note(
          "%s of %s threads: photos of this size fill the memory", outcome.threads(), count);
    }
    outcome.warnings().forEach(line -> screen.err().println("warning: " + Place.printable(line)));
    screen.say(
        "%s photos measured%s by OpenCV %s: %s",
        photos,
        outcome.resumed() > 0 ? ", " + outcome.resumed() + " of them by an earlier call" : "",
        OpenCv.version(),
        folder.resolve(MeasurementsFile.NAME));
  }

  private MeasureSettings settings() {
    Ranges.within("--ratio", ratio, Double.MIN_NORMAL, 1);
    Ranges.within("--false-alarms", falseAlarms, 0, 0.5);
    List<String> names = detectors.stream().map(MeasureCommand::name).distinct().toList();
    names.forEach(Detectors::column);
    return new MeasureSettings(names, new RatioTest(metric, ratio), pip, falseAlarms);
  }

  /** Writes the name of a detector in lower case, except for a file after a colon. */
  private static String name(String text) {
    String[] parts = text.strip().split(":", 2);
    parts[0] = parts[0].toLowerCase(Locale.ROOT);
    return String.join(":", parts);
  }
}
