package org.hificamsim.presentation.replay;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.zip.InflaterInputStream;

/**
 * A {@link RecordedRun} in few bytes.
 *
 * @param frames how many there are
 * @param scale parts of a metre that positions are rounded to
 * @param estimateScale parts of a unit that estimates are rounded to
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
    String data) {
  /** Packs a recording, each frame rounded. */
  static PackedRun of(Setup setup, RecordedRun recording) {
    Scale place = Scale.of(setup.field());
    Scale estimate = Scale.of(largestEstimate(recording.frames()));
    List<FrameColumn> columns =
        FrameColumn.of(setup, place, estimate, !recording.estimated().isEmpty());
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
        FrameColumn.of(setup, new Scale(scale), new Scale(estimateScale), known);
    List<Frame> unpacked = new ArrayList<>(frames);
    try (InputStream in =
        new InflaterInputStream(new ByteArrayInputStream(Base64.getDecoder().decode(data)))) {
      for (long step : Series.read(in, frames)) {
        unpacked.add(Frame.blank(setup, step, known));
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
}
