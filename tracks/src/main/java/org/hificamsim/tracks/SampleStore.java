package org.hificamsim.tracks;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * The samples of each target in their order, in memory that grows with the number of targets alone:
 * the latest ones are kept, those before lie in a temporary file, in blocks that know the place of
 * their target's block before.
 */
final class SampleStore implements Closeable {
  /** Samples of a block. */
  static final int BLOCK = 16;

  private static final int SAMPLE = 3 * Double.BYTES;
  private static final int FIRST = 4; // samples that are kept before there are more
  private static final long NONE = -1;

  /** Takes a sample. */
  interface Taker {
    void sample(double tick, double x, double y) throws IOException;
  }

  /** By target: the place of the block before, then the samples that follow it. */
  private final List<ByteBuffer> latest = new ArrayList<>();

  private FileChannel file;

  /** Adds a sample to a target that is known, or to the next one. */
  void add(int target, double tick, double x, double y) throws IOException {
    if (target == latest.size()) {
      latest.add(ByteBuffer.allocate(Long.BYTES + FIRST * SAMPLE).putLong(NONE));
    }
    ByteBuffer samples = latest.get(target);
    if (!samples.hasRemaining()) {
      samples =
          samples.capacity() < Long.BYTES + BLOCK * SAMPLE ? grown(samples) : written(samples);
      latest.set(target, samples);
    }
    samples.putDouble(tick).putDouble(x).putDouble(y);
  }

  private static ByteBuffer grown(ByteBuffer samples) {
    return ByteBuffer.allocate(2 * samples.capacity() - Long.BYTES).put(samples.flip());
  }

  /** An empty block behind one that is in the file now. */
  private ByteBuffer written(ByteBuffer block) throws IOException {
    file = file == null ? temporary() : file;
    long place = file.size();
    block.flip();
    while (block.hasRemaining()) {
      file.write(block, place + block.position());
    }
    return block.clear().putLong(place);
  }

  private static FileChannel temporary() throws IOException {
    Path path = Files.createTempFile("hificamsim-import", ".samples");
    return FileChannel.open(
        path,
        StandardOpenOption.READ,
        StandardOpenOption.WRITE,
        StandardOpenOption.DELETE_ON_CLOSE);
  }

  /** Hands over a target's samples in the order in which they were added. */
  void each(int target, Taker taker) throws IOException {
    ByteBuffer last = latest.get(target).duplicate().flip();
    Deque<Long> places = new ArrayDeque<>();
    for (long place = last.getLong(); place != NONE; place = read(place, Long.BYTES).getLong()) {
      places.push(place);
    }
    for (long place : places) {
      each(read(place + Long.BYTES, BLOCK * SAMPLE), taker);
    }
    each(last, taker);
  }

  private ByteBuffer read(long place, int bytes) throws IOException {
    ByteBuffer read = ByteBuffer.allocate(bytes);
    while (read.hasRemaining() && file.read(read, place + read.position()) >= 0) {
      // the rest follows
    }
    return read.flip();
  }

  private static void each(ByteBuffer samples, Taker taker) throws IOException {
    while (samples.hasRemaining()) {
      taker.sample(samples.getDouble(), samples.getDouble(), samples.getDouble());
    }
  }

  @Override
  public void close() throws IOException {
    if (file != null) {
      file.close();
    }
  }
}
