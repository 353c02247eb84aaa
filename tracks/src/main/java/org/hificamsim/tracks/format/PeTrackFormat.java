package org.hificamsim.tracks.format;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * PeTrack, JuPedSim and the Juelich data archive: {@code id frame x y [z]} between any separators.
 * Comments may have the rate and the unit, such as {@code # framerate: 25} and {@code # id frame
 * x/cm y/cm}; those that the user gives take precedence.
 */
final class PeTrackFormat implements TrackFormat {
  static final KnownFormat DECLARATION =
      new KnownFormat(
          "petrack",
          "PeTrack, Juelich, JuPedSim's text: `id frame x y [z]`, with comments between any"
              + " separators",
          "`# framerate: 16`, or `{rate}`",
          "`# id frame x/cm y/cm`, or `{unit}`",
          PeTrackFormat::new);

  private static final Pattern RATE =
      Pattern.compile("frame\\s*rate\\W*?\\s*[:=]?\\s*([0-9]+(\\.[0-9]+)?)");
  private static final Pattern UNIT =
      Pattern.compile(
          "\\bx\\s*(?:/|in|\\[)\\s*(mm|cm|m)\\b|\\bx\\s*,\\s*y\\b.*\\(in (m)et(?:re|er)s\\)");
  private static final Pattern HEADER = Pattern.compile("frame\\s*rate|\\bid\\W+fr(ame)?\\b");

  private static final RowFormat ROWS = new RowFormat("id frame x y");
  private static final RowShape SHAPE = RowShape.blanks("PeTrack", 4, 5);

  private OptionalDouble rate = OptionalDouble.empty();
  private Optional<Unit> unit = Optional.empty();

  /** Whether comments name the rate, or the id as the first column. */
  static boolean hasHeader(FileStart start) {
    return start.comments().stream()
        .anyMatch(comment -> HEADER.matcher(comment.toLowerCase(Locale.ROOT)).find());
  }

  @Override
  public FormatFit fit(FileStart start, Recording recording) {
    FormatFit shape = SHAPE.fit(start);
    if (start.isTable() && start.columns() >= SHAPE.least() && hasHeader(start)) {
      return FormatFit.yes("has comments with the rate or the columns");
    }
    return shape.fits() ? ColumnOrder.fit(start, 0) : shape;
  }

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    rate = recording.rate();
    unit = recording.unit();
    recording.start().comments().forEach(line -> readComment(line.toLowerCase(Locale.ROOT)));
    Recording complete = new Recording(recording.file(), rate, unit, recording.columns());
    Ticks ticks = Ticks.of(complete, 1);
    samples.measuredIn(complete.requireUnit("no line such as '# id frame x/m y/m' has it"));
    RowTable.forEachRowOfNumbers(
        recording,
        "rows of id, frame, x, y",
        row -> samples.reading(() -> samples.accept(ROWS.sample(row, ticks))));
    return ticks.clock();
  }

  private void readComment(String text) {
    Matcher rateMatcher = RATE.matcher(text);
    if (rate.isEmpty() && rateMatcher.find()) {
      rate = OptionalDouble.of(Double.parseDouble(rateMatcher.group(1)));
    }
    Matcher unitMatcher = UNIT.matcher(text);
    if (unit.isEmpty() && unitMatcher.find()) {
      String name = unitMatcher.group(1) == null ? unitMatcher.group(2) : unitMatcher.group(1);
      unit = Optional.of(Unit.valueOf(name.toUpperCase(Locale.ROOT)));
    }
  }
}
