package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Ranges;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.hifi.boxes.BoxDetection;
import org.hificamsim.profiling.boxes.BoxFit;
import org.hificamsim.profiling.boxes.BoxFolder;
import org.hificamsim.profiling.boxes.BoxRecording;
import org.hificamsim.profiling.boxes.FoundTable;
import org.hificamsim.profiling.boxes.MeasuredBoxes;
import org.hificamsim.profiling.boxes.ModelCheck;
import org.hificamsim.profiling.boxes.RecordingCounts;
import org.hificamsim.profiling.fit.Reliability;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim profile boxes}: makes a model of a detector from labelled recordings. */
@Command(
    name = "boxes",
    description = {
      "Fits a detection model to labelled recordings of people and the boxes of any detector.",
      "Writes boxes.csv, found.csv, found.png and models/NAME.json. With --model it fits nothing,"
          + " but says what the model expects of the recordings."
    })
final class BoxesCommand implements Callable<Integer> {
  private static final Path DEFAULT_FOLDER = Path.of("out/boxes");
  private static final String NAME = "[A-Za-z0-9][A-Za-z0-9:._-]{0,99}";

  @Parameters(
      paramLabel = "GT DET",
      arity = "2..*",
      description =
          "Labels and detections of each recording: MOTChallenge text, COCO JSON or YOLO folders.")
  private List<Path> files;

  @Option(names = "--out", paramLabel = "DIR")
  private Optional<Path> out;

  @Option(names = "--model", paramLabel = "NAME|FILE.json")
  private Optional<String> model;

  @Option(names = "--name", paramLabel = "NAME")
  private String name;

  @Option(names = "--overlap", paramLabel = "IOU")
  private double overlap;

  @Option(names = "--score", paramLabel = "S")
  private double score;

  @Option(names = "--class", paramLabel = "NAME")
  private Optional<String> type;

  @Mixin private ImageSizeOption image;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    Ranges.within("--overlap", overlap, Double.MIN_NORMAL, 1);
    Ranges.within("--score", score, 0, 1);
    requireName();
    Optional<BoxDetection> givenModel = model.map(BoxesCommand::read);
    MeasuredBoxes measured = MeasuredBoxes.of(recordings(), overlap);
    if (givenModel.isPresent()) {
      printCheck(givenModel.get(), measured);
      if (out.isPresent()) {
        write(out.get(), measured, givenModel, Optional.empty());
      }
    } else {
      fit(measured);
    }
    return 0;
  }

  private void requireName() {
    if (!name.matches(NAME)) {
      throw InputException.of(
          "--name is '%s', expected 1 to 100 letters, digits, or any of : . _ -", name);
    }
  }

  private static BoxDetection read(String nameOrFile) {
    if (Catalogue.load().detection(nameOrFile) instanceof BoxDetection boxes) {
      return boxes;
    }
    throw InputException.of(
        "--model is '%s', expected a model that profile boxes has fitted", nameOrFile);
  }

  private List<BoxRecording> recordings() {
    if (files.size() % 2 != 0) {
      throw InputException.of(
          "there are %s files, expected pairs of labels and detections", files.size());
    }
    BoxRecording.Reading reading = new BoxRecording.Reading(image.size(), type, score);
    List<BoxRecording> recordings = new ArrayList<>();
    for (int i = 0; i < files.size(); i += 2) {
      recordings.add(BoxRecording.read(files.get(i), files.get(i + 1), reading));
    }
    return recordings;
  }

  private void fit(MeasuredBoxes measured) throws IOException {
    Path folder = out.orElse(DEFAULT_FOLDER);
    BoxFit fit = BoxFit.of(measured);
    Optional<BoxDetection> fitted =
        fit.rejected() ? Optional.empty() : Optional.of(fit.detection(name));
    write(folder, measured, fitted, fitted);
    printRecordings(measured);
    if (fit.rejected()) {
      throw new InputException(fit.refusal(name));
    }
    printFit(fit, fitted.get());
    terminal().printf("model: %s%n", folder.resolve(BoxFolder.modelFile(name)));
    terminal().printf("picture: %s%n", folder.resolve(BoxFolder.PICTURE + ".png"));
  }

  private void write(
      Path path,
      MeasuredBoxes measured,
      Optional<BoxDetection> shown,
      Optional<BoxDetection> fitted)
      throws IOException {
    try (OutputFolder folder = Destination.folder(spec, path)) {
      BoxFolder.write(folder, measured, shown, fitted);
    }
  }

  private void printRecordings(MeasuredBoxes measured) {
    for (RecordingCounts counts : measured.recordings()) {
      terminal()
          .printf(
              "%s: %s boxes of %s people in %s, %s found, %s false alarms a frame%s%n",
              counts.recording(),
              counts.boxes(),
              counts.people(),
              Texts.counted(counts.frames(), "frame"),
              Texts.format("%.3f", counts.found()),
              Texts.format("%.3f", counts.falseAlarmsPerFrame()),
              counts.outside() == 0
                  ? ""
                  : "; left out: "
                      + Texts.counted(counts.outside(), "detection")
                      + " in frames without labels");
    }
    new FoundTable(measured).lines().forEach(terminal()::println);
  }

  private void printFit(BoxFit fit, BoxDetection detection) {
    terminal()
        .println(detection.equation() + "; px: height in pixels, h: hidden share" + widthNote(fit));
    terminal().println(fit.width());
    fit.losses().forEach(terminal()::println);
    printFifths(fit.modelReliability());
  }

  private static String widthNote(BoxFit fit) {
    return fit.curve().width().counts() ? ", w: width in pixels" : "";
  }

  private void printCheck(BoxDetection givenModel, MeasuredBoxes measured) {
    Reliability check = ModelCheck.of(givenModel.curve(), measured.boxes());
    terminal().println(Texts.format("measured %.3f", check.all().detected()));
    terminal().println(Texts.format("expected %.3f", check.all().expected()));
    terminal().println(Texts.format("log loss %.3f", check.logLoss()));
    printFifths(check);
  }

  private void printFifths(Reliability reliability) {
    List<Reliability.Part> fifths = reliability.fifths();
    for (int i = 0; i < fifths.size(); i++) {
      Reliability.Part fifth = fifths.get(i);
      terminal()
          .println(
              Texts.format(
                  "fifth %d of the boxes by chance: %.3f by the model, %.3f found",
                  i + 1, fifth.expected(), fifth.detected()));
    }
  }

  private PrintWriter terminal() {
    return spec.commandLine().getOut();
  }
}
