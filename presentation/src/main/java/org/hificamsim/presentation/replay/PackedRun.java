package org.hificamsim.presentation.replay;

import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.annotation.JsonSetter;
import com.fasterxml.jackson.annotation.Nulls;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.function.ObjLongConsumer;
import java.util.function.ToLongFunction;
import java.util.zip.InflaterInputStream;

/**
 * A {@link RecordedRun} in few bytes.
 *
 * @param frames how many there are
 * @param scale parts of a metre that positions are rounded to
 * @param estimateScale parts of a unit that estimates are rounded to
 * @param beliefs how many numbers of {@link BeliefFrame} each frame has; 0 for none
 * @param data a {@link Series} for the frames' steps, then one for each {@link FrameColumn};
 *     deflated (zlib), in Base64
 */
public record PackedRun(
    int run,
    long seed,
    long steps,
    long every,
    String estimated,
    List<Move> moves,
    int frames,
    double scale,
    double estimateScale,
    @JsonInclude(JsonInclude.Include.NON_DEFAULT) @JsonSetter(nulls = Nulls.AS_EMPTY) int beliefs,
    String data) {
  /** Packs a recording, each frame rounded. */
  static PackedRun of(Setup setup, RecordedRun recording) {
    Scale place = Scale.of(setup.field());
    Scale estimate = Scale.of(largestEstimate(recording.frames()));
    int beliefs = recording.frames().get(0).belief().length;
    List<FrameColumn> columns =
        FrameColumn.of(setup, place, estimate, !recording.estimated().isEmpty(), beliefs);
    return new PackedRun(
        recording.run(),
        recording.seed(),
        recording.steps(),
        recording.every(),
        recording.estimated(),
        recording.moves(),
        recording.frames().size(),
        place.perUnit(),
        estimate.perUnit(),
        beliefs,
        pack(recording.frames(), columns));
  }

  /** How many bytes this takes in a file, but for a hundred or so. */
  long bytes() {
    return data.length() + (long) ReplayJson.of(moves).length();
  }

  /**
   * The frames, as rounded.
   *
   * @throws IOException when the data are not what {@link #of} makes for this setup
   */
  RecordedRun unpack(Setup setup) throws IOException {
    boolean known = !estimated.isEmpty();
    List<FrameColumn> columns =
        FrameColumn.of(setup, new Scale(scale), new Scale(estimateScale), known, beliefs);
    List<Frame> unpacked = new ArrayList<>(frames);
    try (InputStream in =
        new InflaterInputStream(new ByteArrayInputStream(Base64.getDecoder().decode(data)))) {
      for (long step : Series.read(in, frames)) {
        unpacked.add(Frame.blank(setup, step, known, beliefs > 0));
      }
      for (FrameColumn column : columns) {
        long[] numbers = Series.read(in, frames);
        for (int i = 0; i < frames; i++) {
          column.unpack().accept(unpacked.get(i), numbers[i]);
        }
      }
    } catch (IllegalArgumentException e) {
      throw new IOException("no Base64", e);
    }
    return new RecordedRun(run, seed, steps, every, estimated, moves, unpacked);
  }

  private static String pack(List<Frame> frames, List<FrameColumn> columns) {
    return Deflated.base64(
        Deflated.FAST,
        out -> {
          Series.write(out, frames.stream().mapToLong(Frame::step));
          for (FrameColumn column : columns) {
            Series.write(out, frames.stream().mapToLong(column.pack()));
          }
        });
  }

  private static double largestEstimate(List<Frame> frames) {
    return frames.stream()
        .flatMap(frame -> Arrays.stream(frame.estimates()))
        .flatMapToDouble(Arrays::stream)
        .filter(estimate -> !Double.isNaN(estimate))
        .map(Math::abs)
        .max()
        .orElse(1);
  }

  /**
   * One number of each frame, as a whole number: to be packed and unpacked.
   *
   * <p>{@link #of} gives the order of columns in {@code replay.json}, which {@code docs/report.md}
   * and the page's {@code recording.js} follow.
   */
  private record FrameColumn(ToLongFunction<Frame> pack, ObjLongConsumer<Frame> unpack) {
    private static final Scale COUNT = new Scale(1);
    private static final Scale BELIEF = new Scale(BeliefFrame.PARTS);

    /** The columns of all frames, in the order in which they are stored. */
    static List<FrameColumn> of(
        Setup setup, Scale place, Scale estimate, boolean estimated, int beliefs) {
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
      for (int i = 0; i < beliefs; i++) {
        addBelief(columns, i);
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

    private static void addBelief(List<FrameColumn> columns, int i) {
      columns.add(
          new FrameColumn(
              f -> BELIEF.pack(f.belief()[i]), (f, v) -> f.belief()[i] = BELIEF.unpack(v)));
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

    private static long bit(boolean value) {
      return value ? 1 : 0;
    }
  }
}
