package org.hificamsim.tracks.format;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.file.TextLines;

/**
 * PeTrack and the Juelich data archive: {@code id frame x y [z]}. Comments may have the rate and
 * the unit, such as {@code # framerate: 25} and {@code # id frame x/cm y/cm}; those that the user
 * gives take precedence.
 */
final class PeTrackFormat implements TrackFormat {
  private static final Pattern RATE =
      Pattern.compile("frame\\s*rate\\W*?\\s*[:=]?\\s*([0-9]+(\\.[0-9]+)?)");
  private static final Pattern UNIT = Pattern.compile("\\bx\\s*(?:/|in|\\[)\\s*(mm|cm|m)\\b");

  private static final RowFormat ROWS = new RowFormat("id frame x y");

  private OptionalDouble rate = OptionalDouble.empty();
  private Optional<Unit> unit = Optional.empty();

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    rate = recording.rate();
    unit = recording.unit();
    Clock clock = null;
    try (TextLines lines = TextLines.open(recording.file())) {
      while (lines.next()) {
        if (lines.isComment()) {
          readComment(lines.text().toLowerCase(Locale.ROOT));
        } else if (lines.count() > 0) {
          clock = clock == null ? begin(recording, samples) : clock;
          samples.accept(ROWS.sample(lines));
        }
      }
    }
    return clock == null ? begin(recording, samples) : clock;
  }

  private void readComment(String text) {
    Matcher rateMatcher = RATE.matcher(text);
    if (rate.isEmpty() && rateMatcher.find()) {
      rate = OptionalDouble.of(Double.parseDouble(rateMatcher.group(1)));
    }
    Matcher unitMatcher = UNIT.matcher(text);
    if (unit.isEmpty() && unitMatcher.find()) {
      unit = Optional.of(Unit.valueOf(unitMatcher.group(1).toUpperCase(Locale.ROOT)));
    }
  }

  private Clock begin(Recording recording, SampleSink samples) {
    Recording complete = new Recording(recording.file(), rate, unit, recording.columns());
    Clock clock = complete.frames();
    samples.measuredIn(complete.requireUnit("no line such as '# id frame x/m y/m' has it"));
    return clock;
  }
}
