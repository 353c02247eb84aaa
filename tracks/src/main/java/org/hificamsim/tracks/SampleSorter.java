package org.hificamsim.tracks;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Sorts samples by target in little memory, however many there are: what does not fit is sorted in
 * parts, which lie in a temporary file until they are merged. Samples of a target keep their order.
 */
final class SampleSorter implements Closeable {
  /** Samples of a part. */
  static final int PART = 1 << 19;

  private final int[] targets;
  private final double[] ticks;
  private final double[] xs;
  private final double[] ys;
  private final long[] keys; // target, then place in the part
  private final List<SampleRun> runs = new ArrayList<>();
  private final ByteBuffer buffer = ByteBuffer.allocate(SampleRun.BUFFER);
  private FileChannel file;
  private int count;

  SampleSorter() {
    this(PART);
  }

  /**
   * @param part how many samples are kept in the memory
   */
  SampleSorter(int part) {
    targets = new int[part];
    ticks = new double[part];
    xs = new double[part];
    ys = new double[part];
    keys = new long[part];
  }

  /** Adds a sample; those of one target in the order of time. */
  void add(int target, double tick, double x, double y) {
    if (count == keys.length) {
      spill();
    }
    keys[count] = ((long) target << 32) | count;
    targets[count] = target;
    ticks[count] = tick;
    xs[count] = x;
    ys[count++] = y;
  }

  /** Writes a part out, sorted. */
  private void spill() {
    try {
      file = file == null ? temporary() : file;
      Arrays.sort(keys, 0, count);
      long start = file.size();
      for (int i = 0; i < count; i++) {
        write((int) keys[i]);
      }
      flush();
      runs.add(new SampleRun(file, start, count));
      count = 0;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static FileChannel temporary() throws IOException {
    Path path = Files.createTempFile("hificamsim-import", ".samples");
    return FileChannel.open(
        path,
        StandardOpenOption.READ,
        StandardOpenOption.WRITE,
        StandardOpenOption.DELETE_ON_CLOSE);
  }

  private void write(int sample) throws IOException {
    if (buffer.remaining() < SampleRun.BYTES) {
      flush();
    }
    buffer.putInt(targets[sample]).putDouble(ticks[sample]);
    buffer.putDouble(xs[sample]).putDouble(ys[sample]);
  }

  private void flush() throws IOException {
    buffer.flip();
    long end = file.size();
    while (buffer.hasRemaining()) {
      end += file.write(buffer, end);
    }
    buffer.clear();
  }

  /** All samples, by target. */
  SortedSamples sorted() {
    if (count > 0) {
      spill();
    }
    return new SortedSamples(runs);
  }

  @Override
  public void close() throws IOException {
    if (file != null) {
      file.close();
    }
  }
}
