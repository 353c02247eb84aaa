package org.hificamsim.tracks.format;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.NamedSetting;
import org.hificamsim.core.file.Fields;

/**
 * A table of values separated by commas, semicolons, tabs or blanks, whose columns the user names.
 * A table without a column of ids is about one target.
 */
final class CsvFormat implements TrackFormat {
  static final KnownFormat DECLARATION =
      new KnownFormat(
          "csv",
          "a table between `,`, `;`, tabs or blanks",
          "any, or frames with `{rate}`",
          "`{unit}`",
          CsvFormat::new);

  private static final String ONLY_TARGET = "1";

  /** A whole number in a table of decimal numbers, such as 12.0. */
  private static final Pattern WHOLE_WITH_POINT = Pattern.compile("[0-9]+\\.0+");

  private Ticks ticks; // null before the first line
  private boolean mayHaveMore;
  private CsvColumns columns; // null before the first line

  @Override
  public boolean namesColumns() {
    return true;
  }

  @Override
  public boolean hasIds() {
    return columns != null && columns.target() >= 0;
  }

  @Override
  public FormatFit fit(FileStart start, Recording recording) {
    if (!start.isTable()) {
      return FormatFit.no("the file %s, a table has rows".formatted(start.look()));
    }
    if (recording.columns().containsKey("x") || recording.columns().containsKey("y")) {
      return FormatFit.yes(start.look() + ", which are named");
    }
    List<String> names = start.rows().get(0).texts();
    boolean hasTime =
        CsvColumns.indexOf(names, "time") >= 0 || CsvColumns.indexOf(names, "frame") >= 0;
    return FormatFit.named(
        CsvColumns.indexOf(names, "x") >= 0
            && CsvColumns.indexOf(names, "y") >= 0
            && (hasTime || recording.columns().containsKey("time")),
        "has the columns " + String.join(", ", names),
        "the columns of the table have no names");
  }

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    CsvColumns.requireValidKeys(recording);
    FileStart start = recording.start();
    mayHaveMore = start.separator() == Separator.BLANKS;
    samples.measuredIn(recording.requireUnit("a table does not have it"));
    RowTable.forEachRow(
        recording, "fields between separators", row -> read(recording, row, samples));
    return ticks == null ? Clock.SECONDS : ticks.clock();
  }

  private void read(Recording recording, Fields row, SampleSink samples) {
    boolean isFirst = columns == null;
    if (isFirst && isComment(recording, row)) {
      return;
    }
    if (isFirst) {
      columns = CsvColumns.find(recording, row);
      ticks = columns.ticks(recording, row);
      columns.requireLongitudeFirst(recording, row);
    }
    if (isFirst && columns.isHeader()) {
      return;
    }
    if (columns.isEmpty(row)) {
      samples.leaveOut(
          Omission.OTHER_THING,
          () -> row.invalid(columns.target(), "id", "a name or number, as in other rows"));
    } else {
      samples.reading(() -> accept(sample(row), samples));
    }
  }

  private void accept(TrackSample sample, SampleSink samples) {
    try {
      samples.accept(sample);
    } catch (InputException fault) {
      throw columns.target() < 0 ? onlyTarget(fault) : fault;
    }
  }

  private static InputException onlyTarget(InputException fault) {
    return InputException.of(
            "%s; all rows are of one target, as there is no column id, expected %s if they are not",
            fault.message(NamedSetting.MARKED), setting("columns", "id=NAME"))
        .because(fault);
  }

  /** Whether a line before the table is a comment, and not the names of columns. */
  private static boolean isComment(Recording recording, Fields row) {
    String x = recording.columns().getOrDefault("x", "x");
    return row.text(0).startsWith("#")
        && IntStream.range(0, row.count()).noneMatch(i -> row.text(i).equals(x));
  }

  private TrackSample sample(Fields row) {
    if (row.count() == columns.count()
        && (columns.target() < 0 || !row.text(columns.target()).isBlank())) {
      TrackSample sample =
          sized(
              row,
              target(row),
              ticks.value(row, columns.tick()),
              row.value(columns.x()),
              row.value(columns.y()));
      if (sample.isValid()) {
        return sample;
      }
    }
    return oddSample(row);
  }

  /** Reads a row part by part, to find the one that is wrong. */
  private TrackSample oddSample(Fields row) {
    OddRows.part(Omission.OTHER_COLUMNS, () -> requireSameColumns(row));
    String target = OddRows.part(Omission.NO_TARGET, () -> target(row));
    return sized(
        row,
        target,
        OddRows.part(Omission.NO_TIME, () -> ticks.tick(row, columns.tick())),
        OddRows.part(Omission.NO_PLACE, () -> row.coordinate(columns.x(), "x")),
        OddRows.part(Omission.NO_PLACE, () -> row.coordinate(columns.y(), "y")));
  }

  private TrackSample sized(Fields row, String target, double tick, double x, double y) {
    double width = length(row, columns.width());
    double height = length(row, columns.height());
    return new TrackSample(
        row.place(0),
        target,
        tick,
        x,
        y,
        columns.width() < 0 ? height : width,
        columns.height() < 0 ? width : height);
  }

  private int requireSameColumns(Fields row) {
    int more = row.count() - columns.count();
    boolean endsEmpty = more == 1 && row.text(row.count() - 1).isBlank();
    if (more < 0 || (more > 0 && !endsEmpty && !mayHaveMore)) {
      throw row.place(0)
          .error("the row has %s cells, expected %s".formatted(row.count(), columns.count()));
    }
    return more;
  }

  private String target(Fields row) {
    if (columns.target() < 0) {
      return ONLY_TARGET;
    }
    String name = row.text(columns.target());
    if (name.isBlank()) {
      throw row.invalid(columns.target(), "id", "a name or number");
    }
    return name.indexOf('.') > 0 && WHOLE_WITH_POINT.matcher(name).matches()
        ? name.substring(0, name.indexOf('.'))
        : name;
  }

  /** The length in a column; NaN if the row has none. */
  private static double length(Fields row, int column) {
    double length = column < 0 || column >= row.count() ? Double.NaN : row.value(column);
    return length > 0 && length <= 1e9 ? length : Double.NaN;
  }
}
