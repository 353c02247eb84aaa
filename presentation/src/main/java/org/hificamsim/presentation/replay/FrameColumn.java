package org.hificamsim.presentation.replay;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ObjLongConsumer;
import java.util.function.ToLongFunction;

/**
 * One number of each frame, as a whole number: to be packed and unpacked.
 *
 * <p>{@link #of} gives the order of columns in {@code replay.json}, which {@code docs/report.md}
 * and the page's {@code recording.js} follow.
 */
record FrameColumn(ToLongFunction<Frame> pack, ObjLongConsumer<Frame> unpack) {
  /** The columns of all frames, in the order in which they are stored. */
  static List<FrameColumn> of(Setup setup, Scale place, Scale estimate, boolean estimated) {
    List<FrameColumn> columns = new ArrayList<>();
    for (int camera = 0; camera < setup.cameras().size(); camera++) {
      addCamera(columns, camera);
    }
    for (int target = 0; target < setup.targets().size(); target++) {
      addTarget(columns, target, place);
    }
    for (int camera = 0; estimated && camera < setup.cameras().size(); camera++) {
      int views = setup.cameras().get(camera).pose().views();
      for (int view = 0; view < views; view++) {
        addEstimate(columns, camera, view, estimate);
      }
    }
    for (int camera = 0; !setup.slow().isEmpty() && camera < setup.cameras().size(); camera++) {
      addSeeing(columns, camera);
    }
    return columns;
  }

  private static void addCamera(List<FrameColumn> columns, int c) {
    columns.add(new FrameColumn(f -> bit(f.online()[c]), (f, v) -> f.online()[c] = v != 0));
    columns.add(new FrameColumn(f -> f.level()[c], (f, v) -> f.level()[c] = (int) v));
    columns.add(new FrameColumn(f -> f.detected()[c], (f, v) -> f.detected()[c] = (int) v));
  }

  private static void addTarget(List<FrameColumn> columns, int t, Scale s) {
    columns.add(new FrameColumn(f -> bit(f.present()[t]), (f, v) -> f.present()[t] = v != 0));
    columns.add(new FrameColumn(f -> s.pack(f.x()[t]), (f, v) -> f.x()[t] = s.unpack(v)));
    columns.add(new FrameColumn(f -> s.pack(f.y()[t]), (f, v) -> f.y()[t] = s.unpack(v)));
    columns.add(new FrameColumn(f -> f.coverage()[t], (f, v) -> f.coverage()[t] = (int) v));
  }

  private static void addSeeing(List<FrameColumn> columns, int c) {
    columns.add(new FrameColumn(f -> f.seeing()[c], (f, v) -> f.seeing()[c] = (int) v));
  }

  private static void addEstimate(List<FrameColumn> columns, int c, int l, Scale s) {
    columns.add(
        new FrameColumn(
            f -> s.packOptional(f.estimates()[c][l]),
            (f, v) -> f.estimates()[c][l] = s.unpackOptional(v)));
    columns.add(
        new FrameColumn(
            f -> COUNT.packOptional(f.counts()[c][l]),
            (f, v) -> f.counts()[c][l] = COUNT.unpackOptional(v)));
  }

  private static final Scale COUNT = new Scale(1);

  private static long bit(boolean value) {
    return value ? 1 : 0;
  }
}
