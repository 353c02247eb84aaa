package org.hificamsim.tracks;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;

/** A sorted part of the samples, in a temporary file; it stands at one of them. */
final class SampleRun {
  /** Of a sample: its target's number, time, x and y. */
  static final int BYTES = Integer.BYTES + 3 * Double.BYTES;

  static final int BUFFER = BYTES << 11;

  private final FileChannel file;
  private final ByteBuffer buffer = ByteBuffer.allocate(BUFFER).limit(0);
  private long at;
  private long left;
  private int target;
  private double tick;
  private double x;
  private double y;

  SampleRun(FileChannel file, long start, long samples) {
    this.file = file;
    this.at = start;
    this.left = samples;
  }

  /** Goes to the next sample; false at the end. */
  boolean next() {
    if (left == 0) {
      return false;
    }
    left--;
    if (!buffer.hasRemaining()) {
      fill();
    }
    target = buffer.getInt();
    tick = buffer.getDouble();
    x = buffer.getDouble();
    y = buffer.getDouble();
    return true;
  }

  private void fill() {
    try {
      buffer.clear().limit((int) Math.min(BUFFER, (left + 1) * BYTES));
      while (buffer.hasRemaining()) {
        at += file.read(buffer, at);
      }
      buffer.flip();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  int target() {
    return target;
  }

  double tick() {
    return tick;
  }

  double x() {
    return x;
  }

  double y() {
    return y;
  }
}
