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
import java.util.function.Function;
import java.util.function.ObjLongConsumer;
import java.util.function.ToLongFunction;
import java.util.zip.InflaterInputStream;

/**
 * A {@link RecordedRun} in few bytes.
 *
 * @param frames the number of frames
 * @param scale positions are rounded to multiples of 1 / scale metres
 * @param estimateScale estimates are rounded to multiples of 1 / estimateScale
 * @param beliefs how many numbers of {@link BeliefFrame} each frame has; 0 for none
 * @param data a {@link Series} for the frames' steps, then one for each {@link FrameColumn},
 *     compressed (zlib) and in Base64
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
  /** Packs a recording, and rounds the numbers of its frames. */
  static PackedRun of(Setup setup, RecordedRun recording) {
    Scale positions = Scale.of(setup.field());
    Scale estimates = Scale.of(largestEstimate(recording.frames()));
    int beliefs = recording.frames().get(0).belief().length;
    List<FrameColumn> columns =
        FrameColumn.of(setup, positions, estimates, !recording.estimated().isEmpty(), beliefs);
    return new PackedRun(
        recording.run(),
        recording.seed(),
        recording.steps(),
        recording.every(),
        recording.estimated(),
        recording.moves(),
        recording.frames().size(),
        positions.perUnit(),
        estimates.perUnit(),
        beliefs,
        pack(recording.frames(), columns));
  }

  /** Returns about the number of bytes that this takes in a file, at most a hundred off. */
  long bytes() {
    return data.length() + (long) ReplayJson.of(moves).length();
  }

  /**
   * Unpacks the recording, with rounded numbers.
   *
   * @throws IOException if the data are not those that {@link #of} makes for this setup
   */
  RecordedRun unpack(Setup setup) throws IOException {
    boolean hasEstimates = !estimated.isEmpty();
    List<FrameColumn> columns =
        FrameColumn.of(setup, new Scale(scale), new Scale(estimateScale), hasEstimates, beliefs);
    List<Frame> unpacked = new ArrayList<>(frames);
    try (InputStream in =
        new InflaterInputStream(new ByteArrayInputStream(Base64.getDecoder().decode(data)))) {
      for (long step : Series.read(in, frames)) {
        unpacked.add(Frame.blank(setup, step, hasEstimates, beliefs > 0));
      }
      for (FrameColumn column : columns) {
        long[] numbers = Series.read(in, frames);
        for (int i = 0; i < frames; i++) {
          column.unpack().accept(unpacked.get(i), numbers[i]);
        }
      }
    } catch (IllegalArgumentException e) {
      throw new IOException("the data are not Base64", e);
    }
    return new RecordedRun(run, seed, steps, every, estimated, moves, unpacked);
  }

  private static String pack(List<Frame> frames, List<FrameColumn> columns) {
    return Deflated.base64(
        Deflated.FAST_LEVEL,
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
   * Converts one value of each frame to a whole number and back.
   *
   * <p>{@link #of} defines the order of columns in {@code replay.json}, which {@code
   * docs/report.md} and the page's {@code recording.js} follow.
   */
  private record FrameColumn(ToLongFunction<Frame> pack, ObjLongConsumer<Frame> unpack) {
    private static final Scale COUNT = new Scale(1);
    private static final Scale BELIEF = new Scale(BeliefFrame.PER_UNIT);

    /** The columns of all frames, in the order in which they are stored. */
    static List<FrameColumn> of(
        Setup setup, Scale positions, Scale estimates, boolean hasEstimates, int beliefs) {
      List<FrameColumn> columns = new ArrayList<>();
      for (int camera = 0; camera < setup.cameras().size(); camera++) {
        addCamera(columns, camera);
      }
      for (int target = 0; target < setup.targets().size(); target++) {
        addTarget(columns, target, positions);
      }
      for (int camera = 0; hasEstimates && camera < setup.cameras().size(); camera++) {
        int views = setup.cameras().get(camera).pose().views();
        for (int view = 0; view < views; view++) {
          addEstimate(columns, camera, view, estimates);
        }
      }
      for (int camera = 0; !setup.slow().isEmpty() && camera < setup.cameras().size(); camera++) {
        columns.add(ofInts(Frame::seeing, camera));
      }
      for (int i = 0; i < beliefs; i++) {
        columns.add(ofDoubles(Frame::belief, i, BELIEF));
      }
      for (int target = 0; setup.following() && target < setup.targets().size(); target++) {
        columns.add(ofInts(Frame::holders, target));
      }
      return columns;
    }

    private static void addCamera(List<FrameColumn> columns, int camera) {
      columns.add(ofBooleans(Frame::online, camera));
      columns.add(ofInts(Frame::level, camera));
      columns.add(ofInts(Frame::detected, camera));
    }

    private static void addTarget(List<FrameColumn> columns, int target, Scale positions) {
      columns.add(ofBooleans(Frame::present, target));
      columns.add(ofDoubles(Frame::x, target, positions));
      columns.add(ofDoubles(Frame::y, target, positions));
      columns.add(ofInts(Frame::coverage, target));
    }

    private static void addEstimate(
        List<FrameColumn> columns, int camera, int view, Scale estimates) {
      columns.add(ofOptionals(frame -> frame.estimates()[camera], view, estimates));
      columns.add(ofOptionals(frame -> frame.counts()[camera], view, COUNT));
    }

    private static FrameColumn ofBooleans(Function<Frame, boolean[]> array, int index) {
      return new FrameColumn(
          frame -> array.apply(frame)[index] ? 1 : 0,
          (frame, value) -> array.apply(frame)[index] = value != 0);
    }

    private static FrameColumn ofInts(Function<Frame, int[]> array, int index) {
      return new FrameColumn(
          frame -> array.apply(frame)[index],
          (frame, value) -> array.apply(frame)[index] = (int) value);
    }

    private static FrameColumn ofDoubles(Function<Frame, double[]> array, int index, Scale scale) {
      return new FrameColumn(
          frame -> scale.pack(array.apply(frame)[index]),
          (frame, value) -> array.apply(frame)[index] = scale.unpack(value));
    }

    private static FrameColumn ofOptionals(
        Function<Frame, double[]> array, int index, Scale scale) {
      return new FrameColumn(
          frame -> scale.packOptional(array.apply(frame)[index]),
          (frame, value) -> array.apply(frame)[index] = scale.unpackOptional(value));
    }
  }
}
