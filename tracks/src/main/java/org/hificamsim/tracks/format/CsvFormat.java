package org.hificamsim.tracks.format;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.dataformat.csv.CsvFactory;
import com.fasterxml.jackson.dataformat.csv.CsvParser;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.Fields;
import org.hificamsim.core.file.TextLines;

/**
 * A table of comma, semicolon or tab separated values with a line of names, of which the user says
 * which column has what.
 */
final class CsvFormat implements TrackFormat {
  private static final int UNKNOWN = -1;
  private static final double LARGE = 1e9;

  private final List<String> row = new ArrayList<>();
  private final List<Place> places = new ArrayList<>();

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    CsvColumns columns = CsvColumns.of(recording);
    Clock clock = columns.ofFrames() ? recording.frames() : Clock.SECONDS;
    samples.measuredIn(recording.requireUnit("a table does not say it"));
    try (CsvParser parser = parser(recording)) {
      boolean more = nextRow(recording, parser);
      CsvColumns.Found found = columns.in(recording, row);
      int width = row.size();
      more = more && (columns.byNumber() || nextRow(recording, parser));
      while (more) {
        requireWidth(width);
        samples.accept(sample(found));
        more = nextRow(recording, parser);
      }
    } catch (IOException e) {
      throw TextLines.unreadable(recording.file().toString(), 1, e);
    }
    return clock;
  }

  private static CsvParser parser(Recording recording) throws IOException {
    char separator = separator(recording);
    InputStream in = TextLines.stream(recording.file());
    CsvParser parser = new CsvFactory().createParser(in);
    parser.setSchema(CsvSchema.emptySchema().withColumnSeparator(separator));
    parser.enable(CsvParser.Feature.WRAP_AS_ARRAY);
    parser.enable(CsvParser.Feature.SKIP_EMPTY_LINES);
    parser.enable(CsvParser.Feature.TRIM_SPACES);
    return parser;
  }

  /** The one of the usual separators that the line of names has most often. */
  private static char separator(Recording recording) {
    try (TextLines lines = TextLines.open(recording.file())) {
      lines.next();
      char best = ',';
      for (char one : new char[] {';', '\t'}) {
        best = count(lines.text(), one) > count(lines.text(), best) ? one : best;
      }
      return best;
    }
  }

  private static long count(String text, char wanted) {
    return text.chars().filter(c -> c == wanted).count();
  }

  private boolean nextRow(Recording recording, CsvParser parser) throws IOException {
    row.clear();
    places.clear();
    try {
      while (parser.nextToken() != null && parser.currentToken() != JsonToken.END_ARRAY) {
        if (parser.currentToken().isScalarValue()) {
          row.add(parser.getText());
          places.add(place(recording, parser.currentTokenLocation()));
        }
      }
      return !row.isEmpty();
    } catch (JsonProcessingException e) {
      throw place(recording, e.getLocation())
          .error("not a table, expected fields between separators: " + e.getOriginalMessage());
    }
  }

  private void requireWidth(int width) {
    if (row.size() != width) {
      throw places
          .get(places.size() - 1)
          .error("the line has " + row.size() + " fields, expected " + width + " as in the first");
    }
  }

  private static Place place(Recording recording, JsonLocation location) {
    return new Place(
        recording.file().toString(),
        Math.max(1, location.getLineNr()),
        Math.max(1, location.getColumnNr()));
  }

  private Sample sample(CsvColumns.Found found) {
    return new Sample(
        places.get(0),
        text(found.target(), "id"),
        number(found.tick(), "time"),
        number(found.x(), "x"),
        number(found.y(), "y"),
        found.width() == UNKNOWN ? Double.NaN : length(found.width(), "width"),
        found.height() == UNKNOWN ? Double.NaN : length(found.height(), "height"));
  }

  private String text(int column, String name) {
    if (column >= row.size() || row.get(column).isEmpty()) {
      throw invalid(column, name, "a name or number");
    }
    return row.get(column);
  }

  private double number(int column, String name) {
    double value = column < row.size() ? Fields.value(row.get(column)) : Double.NaN;
    if (!Double.isFinite(value) || Math.abs(value) > LARGE) {
      throw invalid(column, name, "a number from -1e9 to 1e9");
    }
    return value;
  }

  private double length(int column, String name) {
    double value = number(column, name);
    if (value <= 0) {
      throw invalid(column, name, "a number above 0");
    }
    return value;
  }

  private InputException invalid(int column, String name, String expected) {
    if (column >= row.size()) {
      return places.get(places.size() - 1).error("the line has no " + name + ", expected one");
    }
    return places.get(column).error(name + " is '" + row.get(column) + "', expected " + expected);
  }
}
