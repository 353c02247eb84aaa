package org.hificamsim.tracks.format;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.Fields;

/**
 * Vadere's trajectories: a row for each foot step, with the time and position at which it starts
 * and ends; in older files, a position for each time step. The names of columns end in the number
 * of the processor that wrote them, such as {@code startX-PID1}.
 */
final class VadereFormat implements TrackFormat {
  static final KnownFormat DECLARATION =
      new KnownFormat(
          "vadere",
          "Vadere's `.traj`: `pedestrianId simTime endTime startX startY endX endY`, or `timeStep"
              + " pedestrianId x y`",
          "s; time steps: `{rate}`",
          "m",
          VadereFormat::new);

  private static final String TARGET = "pedestrianId";
  private static final String TIME_STEP = "timeStep";
  private static final String START_TIME = "simTime";
  private static final String END_TIME = "endTime";

  private final Map<String, Integer> columns = new HashMap<>();
  private final Map<String, TrackSample> ends = new HashMap<>();
  private boolean countsSteps;

  @Override
  public FormatFit fit(FileStart start, Recording recording) {
    boolean hasNames =
        start.isTable()
            && start.rows().get(0).texts().contains(TARGET)
            && IntStream.range(0, start.columns())
                .mapToObj(column -> name(start.rows().get(0), column))
                .anyMatch(name -> name.equals("startX") || name.equals("x"));
    return FormatFit.of(
        hasNames,
        "has Vadere's columns",
        "the first row has no pedestrianId and startX, as Vadere");
  }

  private static String name(Fields header, int column) {
    return header.text(column).replaceFirst("-PID[0-9]+$", "");
  }

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    samples.measuredIn(recording.only(Unit.M));
    List<LineFields> rows = recording.start().rows();
    countsSteps = !rows.isEmpty() && rows.get(0).texts().contains(TIME_STEP);
    Clock clock = countsSteps ? recording.frames() : Clock.SECONDS;
    RowTable.forEachRow(recording, "rows of pedestrians", row -> read(row, samples));
    ends.values().forEach(samples::accept);
    return clock;
  }

  private void read(Fields row, SampleSink samples) {
    if (row.text(0).startsWith("#")) {
      return;
    }
    if (columns.isEmpty()) {
      IntStream.range(0, row.count()).forEach(i -> columns.putIfAbsent(name(row, i), i));
    } else if (countsSteps) {
      samples.reading(() -> samples.accept(sample(row, TIME_STEP, "")));
    } else {
      samples.reading(() -> readFootStep(row, samples));
    }
  }

  private void readFootStep(Fields row, SampleSink samples) {
    TrackSample start = sample(row, START_TIME, "start");
    TrackSample end = sample(row, END_TIME, "end");
    TrackSample before =
        end.tick() > start.tick() ? ends.put(start.target(), end) : ends.remove(start.target());
    if (before != null && before.tick() < start.tick()) {
      samples.accept(before); // the pedestrian stood
    }
    samples.accept(start);
  }

  private TrackSample sample(Fields row, String time, String end) {
    String x = end.isEmpty() ? "x" : end + "X";
    String y = end.isEmpty() ? "y" : end + "Y";
    Place place = row.place(0);
    return new TrackSample(
        place,
        OddRows.part(Omission.NO_TARGET, () -> RowFormat.target(row, column(row, TARGET))),
        OddRows.part(Omission.NO_TIME, () -> row.number(column(row, time), time)),
        OddRows.part(Omission.NO_PLACE, () -> row.coordinate(column(row, x), x)),
        OddRows.part(Omission.NO_PLACE, () -> row.coordinate(column(row, y), y)));
  }

  private int column(Fields row, String name) {
    Integer column = columns.get(name);
    if (column == null) {
      throw row.place(0).error("no column %s, expected it in the first row", name);
    }
    return column;
  }
}
