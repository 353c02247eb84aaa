package org.hificamsim.profiling.boxes;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.profiling.check.Calibration.Size;

/**
 * YOLO's format: a folder with a text file for each picture, whose lines are {@code class x y width
 * height [score [id]]}, with the middle and the size of the box as shares of the picture. The last
 * number in a file's name is its frame. Labels without scores may have the id in the sixth column.
 */
final class YoloFolder implements BoxFile {
  private static final Pattern FRAME = Pattern.compile("(\\d{1,15})\\D*$");
  private static final int SCORE = 5;
  private static final int ID = 6;
  private static final double MAX_SHARE = 10;

  private final Path folder;
  private final BoxRecording.Reading reading;

  YoloFolder(Path folder, BoxRecording.Reading reading) {
    this.folder = folder;
    this.reading = reading;
  }

  /** Receives the lines of all files. */
  private interface LineListener {
    void line(long frame, TextLines fields, Box box);
  }

  @Override
  public void labels(LabelListener listener) {
    String type = type();
    SeenIds ids = new SeenIds();
    read(
        (frame, fields, box) -> {
          int column = fields.count() > ID ? ID : SCORE;
          String person = fields.count() > column ? fields.text(column) : null;
          boolean counted = fields.text(0).equals(type);
          if (person != null && counted) {
            ids.add(fields.place(column), frame, person);
          }
          listener.label(frame, new LabelledBox(person, box, Double.NaN, counted));
        });
  }

  @Override
  public void detections(BoxFile labels, DetectedFrames detected) {
    String type = type();
    read(
        (frame, fields, box) -> {
          double score =
              fields.count() > SCORE
                  ? BoxFile.score(fields.place(SCORE), fields.number(SCORE, "score"))
                  : 1;
          if (fields.text(0).equals(type) && score >= reading.leastScore()) {
            detected.add(fields.place(0), frame, box);
          }
        });
  }

  private String type() {
    return reading.type().orElse("0");
  }

  private void read(LineListener listener) {
    Size picture =
        reading
            .picture()
            .orElseThrow(
                () ->
                    InputException.of(
                        "%s: YOLO's files do not say how large the picture is, expected %s",
                        folder, setting("image", "WIDTHxHEIGHT")));
    for (Path file : files()) {
      try (TextLines lines = TextLines.open(file)) {
        while (lines.nextFields()) {
          listener.line(frame(file), lines, box(lines, picture));
        }
      }
    }
  }

  private static Box box(TextLines fields, Size picture) {
    double width = picture.width() * share(fields, 3, "width");
    double height = picture.height() * share(fields, 4, "height");
    double left = picture.width() * share(fields, 1, "x") - width / 2;
    double top = picture.height() * share(fields, 2, "y") - height / 2;
    return BoxFile.box(fields.place(3), left, top, width, height);
  }

  private static double share(TextLines fields, int field, String name) {
    return fields.number(
        field, name, "a share of the picture", value -> value >= -MAX_SHARE && value <= MAX_SHARE);
  }

  private List<Path> files() {
    try (Stream<Path> entries = Files.list(folder)) {
      List<Path> files =
          entries
              .filter(file -> file.toString().endsWith(".txt"))
              .filter(file -> !file.getFileName().toString().equals("classes.txt"))
              .sorted()
              .toList();
      if (files.isEmpty()) {
        throw InputException.of(
            "%s: there is no text file, expected one for each picture, as YOLO has them", folder);
      }
      return files;
    } catch (IOException e) {
      throw new InputException(folder + ": cannot be read, expected a folder: " + e, e);
    }
  }

  private static long frame(Path file) {
    Matcher number = FRAME.matcher(file.getFileName().toString().replaceFirst("\\.txt$", ""));
    if (!number.find()) {
      throw new Place(file.toString(), 1, 1)
          .error("the file's name has no number, expected that of its frame");
    }
    return Long.parseLong(number.group(1));
  }

  @Override
  public Optional<Size> picture() {
    return reading.picture();
  }
}
