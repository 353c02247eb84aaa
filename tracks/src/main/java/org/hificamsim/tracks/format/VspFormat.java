package org.hificamsim.tracks.format;

import java.util.regex.Pattern;
import org.hificamsim.core.file.TextLines;

/**
 * UCY's annotations: splines, each with a number of control points {@code x y frame gaze}, in
 * pixels from the middle of the picture, y up. Text after {@code -} in a line is a comment. Every
 * spline is a target, which gets a sample every ten frames, as in the files of positions of the
 * same recordings.
 */
final class VspFormat implements TrackFormat {
  static final KnownFormat DECLARATION =
      new KnownFormat(
          "vsp",
          "UCY's splines: their number; for each, the number of points and `x y frame gaze`",
          "frames: `{rate}`, a sample every 10",
          "px from the middle of the picture, y up: `{homography=FILE}`",
          VspFormat::new);

  private static final Pattern START =
      Pattern.compile(
          "\\s*\\d+\\s*(-.*)?\\R\\s*\\d+\\s*(-.*)?\\R\\s*[-+.\\d]+\\s+[-+.\\d]+\\s+\\d+.*");

  private static final int FRAMES_PER_SAMPLE = 10;
  private static final int FRAME = 2;

  private TextLines lines;

  @Override
  public FormatFit fit(FileStart start, Recording recording) {
    return FormatFit.of(
        START.matcher(start.text()).lookingAt(),
        "begins with the number of splines and of control points",
        "the file %s, UCY's has a number of splines first".formatted(start.look()));
  }

  @Override
  public Unit usualUnit() {
    return Unit.PX;
  }

  @Override
  public boolean hasIds() {
    return false;
  }

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    Clock clock = recording.frames();
    samples.measuredIn(recording.unit().orElse(Unit.PX));
    try (TextLines opened = TextLines.open(recording.file())) {
      lines = opened;
      long splines = count("number of splines");
      for (long spline = 1; spline <= splines; spline++) {
        readSpline(Long.toString(spline), samples);
      }
    }
    return clock;
  }

  private long count(String name) {
    if (!lines.nextFields()) {
      throw lines.place().error("the file ends, expected the %s", name);
    }
    return (long)
        lines.number(
            0, name, "a whole number from 0", value -> value >= 0 && value == Math.rint(value));
  }

  private void readSpline(String target, SampleSink samples) {
    Spline spline = new Spline(lines.place(), target);
    long points = count("number of control points");
    for (long point = 0; point < points; point++) {
      if (!lines.nextFields()) {
        throw lines.place().error("the file ends, expected %s control points", points);
      }
      samples.reading(() -> addPoint(spline));
    }
    spline.sampleEvery(FRAMES_PER_SAMPLE).forEach(samples::accept);
  }

  private void addPoint(Spline spline) {
    spline.add(
        lines.place(),
        OddRows.part(Omission.NO_TIME, () -> lines.coordinate(FRAME, "frame")),
        OddRows.part(Omission.NO_PLACE, () -> lines.coordinate(0, "x")),
        OddRows.part(Omission.NO_PLACE, () -> lines.coordinate(1, "y")));
  }
}
