package org.hificamsim.profiling.boxes;

import java.nio.file.Path;
import java.util.Optional;
import org.hificamsim.core.Place;
import org.hificamsim.profiling.check.Calibration.Size;
import org.hificamsim.tracks.format.MotFile;

/**
 * MOTChallenge's format: {@code frame,id,left,top,width,height[,conf[,...]]}. In labels a
 * confidence of 0 marks a box that does not count, and with nine columns (MOT16 and later) so does
 * another class than that of pedestrians; in detections the confidence is the score.
 */
final class MotBoxFile implements BoxFile {
  private static final String PEDESTRIAN = "1";

  private final Path file;
  private final BoxRecording.Reading reading;

  MotBoxFile(Path file, BoxRecording.Reading reading) {
    this.file = file;
    this.reading = reading;
  }

  @Override
  public void labels(LabelListener listener) {
    SeenIds ids = new SeenIds();
    String type = reading.type().orElse(PEDESTRIAN);
    MotFile.read(
        file,
        row -> {
          boolean counted =
              row.confidence() != 0 && (row.type().isEmpty() || row.type().equals(type));
          if (counted) {
            ids.add(row.place(), frame(row), row.target());
          }
          Box box = box(row);
          listener.label(frame(row), new LabelledBox(row.target(), box, row.visibility(), counted));
        });
  }

  @Override
  public void detections(BoxFile labels, DetectedFrames detected) {
    MotFile.read(
        file,
        row -> {
          Box box = box(row);
          if (BoxFile.score(row.place(), row.confidence()) >= reading.leastScore()) {
            detected.add(row.place(), frame(row), box);
          }
        });
  }

  private static Box box(MotFile.Row row) {
    return BoxFile.box(row.place(), row.left(), row.top(), row.width(), row.height());
  }

  private static long frame(MotFile.Row row) {
    Place place = row.place();
    if (row.frame() != Math.rint(row.frame())) {
      throw place.invalid("frame", String.valueOf(row.frame()), "a whole number");
    }
    return (long) row.frame();
  }

  @Override
  public Optional<Size> picture() {
    return reading.picture();
  }
}
