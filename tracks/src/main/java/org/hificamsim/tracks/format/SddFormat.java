package org.hificamsim.tracks.format;

import org.hificamsim.core.file.Fields;

/**
 * The Stanford Drone Dataset: boxes seen from above, {@code id xmin ymin xmax ymax frame lost
 * occluded generated "label"}. A target is at the middle of its box. Rows in which it is lost are
 * left out.
 */
final class SddFormat implements TrackFormat {
  static final KnownFormat DECLARATION =
      new KnownFormat(
          "sdd",
          "Stanford Drone Dataset: `id xmin ymin xmax ymax frame lost occluded generated"
              + " \"label\"`",
          "frames: `{rate}`",
          "px: `{homography=FILE}`; the middle of the box",
          SddFormat::new);

  private static final int FRAME = 5;
  private static final int LOST = 6;
  private static final int LABEL = 9;
  private static final RowShape SHAPE = RowShape.blanks("SDD", LABEL + 1, LABEL + 1);

  @Override
  public FormatFit fit(FileStart start, Recording recording) {
    FormatFit shape = SHAPE.fit(start);
    boolean hasLabel = shape.fits() && Double.isNaN(start.rows().get(0).value(LABEL));
    return shape.fits() && !hasLabel
        ? FormatFit.no("column 10 is a number, SDD has a label there")
        : shape;
  }

  @Override
  public Unit usualUnit() {
    return Unit.PX;
  }

  @Override
  public Clock read(Recording recording, SampleSink samples) {
    Ticks ticks = Ticks.of(recording, FRAME);
    samples.measuredIn(recording.only(Unit.PX));
    RowTable.forEachRow(
        recording, "annotations", row -> samples.reading(() -> read(row, ticks, samples)));
    return ticks.clock();
  }

  private static void read(Fields row, Ticks ticks, SampleSink samples) {
    TrackSample sample =
        new TrackSample(
            row.place(0),
            OddRows.part(Omission.NO_TARGET, () -> RowFormat.target(row, 0)),
            OddRows.part(Omission.NO_TIME, () -> ticks.tick(row, FRAME)),
            OddRows.part(Omission.NO_PLACE, () -> middle(row, 1, "x")),
            OddRows.part(Omission.NO_PLACE, () -> middle(row, 2, "y")));
    if (OddRows.part(Omission.OTHER_COLUMNS, () -> row.number(LOST, "lost")) == 1) {
      samples.leaveOut(Omission.MARKED, () -> row.place(LOST).error("lost is 1"));
    } else {
      samples.accept(sample);
    }
  }

  private static double middle(Fields row, int least, String axis) {
    return (row.coordinate(least, axis + "min") + row.coordinate(least + 2, axis + "max")) / 2;
  }
}
