package org.hificamsim.tracks.format;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.EnumSet;
import org.hificamsim.core.InputException;

/**
 * MOTChallenge: positions in the world, or positions of boxes in the picture. Rows whose confidence
 * is 0, and detections, whose id is -1, are left out.
 */
final class MotFormat implements TrackFormat {
  static final KnownFormat DECLARATION =
      new KnownFormat(
          "mot",
          "MOTChallenge: `frame,id,left,top,width,height[,conf[,x,y,z]]`",
          "frames: `{rate}`",
          "`{unit=m}` (`cm`, `mm`): x and y in the world; `{unit=px}` and `{homography=FILE}`:"
              + " where boxes stand",
          MotFormat::new);

  private static final RowShape SHAPE =
      new RowShape(
          "MOTChallenge",
          EnumSet.of(Separator.COMMAS, Separator.SEMICOLONS),
          MotFile.BOX_COLUMNS,
          MotFile.COLUMNS_WITH_WORLD);

  /**
   * The shape of rows with blanks between all columns, as some trackers write them; rows with fewer
   * columns are of another format.
   */
  private static final RowShape BLANK_SHAPE =
      RowShape.blanks("MOTChallenge", MotFile.COLUMNS_WITH_WORLD, MotFile.COLUMNS_WITH_WORLD);

  /** The id in files of detections. */
  private static final String NO_TARGET = "-1";

  @Override
  public FormatFit fit(FileStart start, Recording recording) {
    if (PeTrackFormat.hasHeader(start)) {
      return FormatFit.no("comments say that the first column is the id, MOTChallenge has frames");
    }
    FormatFit blank = BLANK_SHAPE.fitNumbers(start);
    FormatFit shape = blank.fits() ? blank : SHAPE.fitNumbers(start);
    return !shape.fits() || (isWhole(start, 0) && isWhole(start, 1))
        ? shape
        : FormatFit.no(
            "the first two columns are not whole numbers, MOTChallenge has frames and ids: a table"
                + " with times is of the format csv");
  }

  private static boolean isWhole(FileStart start, int column) {
    return start.rows().stream()
        .mapToDouble(row -> column < row.count() ? row.value(column) : 0)
        .filter(Double::isFinite)
        .allMatch(value -> value == Math.rint(value) && value < Times.FIRST_UNIX_TIME);
  }

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    Ticks ticks = Ticks.of(recording, MotFile.FRAME_COLUMN);
    Unit unit = recording.requireUnit("px for boxes, another one for positions in the world");
    samples.measuredIn(unit);
    MotFlags flags = new MotFlags();
    MotFile.read(
        recording,
        ticks,
        samples,
        row -> {
          if (row.confidence() == 0) {
            samples.leaveOut(Omission.MARKED, () -> row.place().error("confidence is 0"));
          } else if (row.target().equals(NO_TARGET)) {
            samples.leaveOut(Omission.NO_TARGET, () -> detection(row));
          } else if (unit == Unit.PX) {
            samples.accept(inPicture(row));
          } else {
            samples.accept(inWorld(row));
            flags.add(row);
          }
        });
    flags.sign().ifPresent(samples::doubt);
    return ticks.clock();
  }

  private static InputException detection(MotFile.Row row) {
    return row.place()
        .error(
            "id is -1, which is a detection of no target, expected the tracks that a tracker has"
                + " made of them");
  }

  private static TrackSample inPicture(MotFile.Row row) {
    return new TrackSample(
        row.place(),
        row.target(),
        row.frame(),
        row.footX(),
        row.footY(),
        row.width(),
        row.height());
  }

  private static TrackSample inWorld(MotFile.Row row) {
    if (!row.isInWorld()) {
      throw noWorld(row);
    }
    return new TrackSample(row.place(), row.target(), row.frame(), row.x(), row.y());
  }

  private static InputException noWorld(MotFile.Row row) {
    return row.place()
        .error(
            "the row has no position in the world, expected %s and %s, which converts boxes to"
                + " positions on the ground",
            setting("unit", "px"), setting("homography", "FILE"));
  }
}
