package org.hificamsim.tracks.format;

import static org.hificamsim.core.NamedSetting.setting;

import org.hificamsim.core.InputException;

/**
 * MOTChallenge: positions in the world, or the places of boxes in the picture. Rows whose
 * confidence is 0 are ignored.
 */
final class MotFormat implements TrackFormat {
  @Override
  public Clock read(Recording recording, SampleSink samples) {
    Clock clock = recording.frames();
    Unit unit = recording.requireUnit("px for boxes, another one for positions in the world");
    samples.measuredIn(unit);
    MotFile.read(
        recording.file(),
        row -> {
          if (row.confidence() != 0) {
            samples.accept(unit == Unit.PX ? inPicture(row) : inWorld(row));
          }
        });
    return clock;
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
