package org.hificamsim.tracks.format;

import java.util.List;
import java.util.OptionalDouble;
import org.hificamsim.core.file.Fields;

/**
 * JuPedSim's trajectories in SQLite: the table {@code trajectory_data}, in metres and frames, and
 * the frames per second in the table {@code metadata}. A rate that the user gives takes precedence.
 */
final class JuPedSimFormat implements TrackFormat {
  static final KnownFormat DECLARATION =
      new KnownFormat(
          "jupedsim",
          "JuPedSim's SQLite: the table `trajectory_data` with `frame id pos_x pos_y`",
          "`fps` in `metadata`, or `{rate}`",
          "m",
          JuPedSimFormat::new);

  private OptionalDouble rate;

  @Override
  public FormatFit fit(FileStart start, Recording recording) {
    return FormatFit.of(
        start.isSqlite(),
        start.look(),
        "the file %s, JuPedSim's trajectories are SQLite".formatted(start.look()));
  }

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    SqliteReader sqlite = SqliteReader.find(recording.file());
    rate = recording.rate();
    samples.measuredIn(recording.only(Unit.M));
    sqlite.read(recording.file(), "metadata", List.of("key", "value"), this::readMetadata);
    boolean found =
        sqlite.read(
            recording.file(),
            "trajectory_data",
            List.of("frame", "id", "pos_x", "pos_y"),
            row -> samples.reading(() -> samples.accept(sample(row))));
    if (!found) {
      throw recording.missing("the table trajectory_data of JuPedSim");
    }
    return rate.isPresent() ? recording.at(rate.getAsDouble()).frames() : recording.frames();
  }

  private void readMetadata(Fields row) {
    if (rate.isEmpty() && row.text(0).equals("fps")) {
      rate = OptionalDouble.of(row.number(1, "fps", "a number above 0", value -> value > 0));
    }
  }

  private static TrackSample sample(Fields row) {
    return new TrackSample(
        row.place(0),
        OddRows.part(Omission.NO_TARGET, () -> RowFormat.target(row, 1)),
        OddRows.part(Omission.NO_TIME, () -> row.number(0, "frame")),
        OddRows.part(Omission.NO_PLACE, () -> row.coordinate(2, "pos_x")),
        OddRows.part(Omission.NO_PLACE, () -> row.coordinate(3, "pos_y")));
  }
}
