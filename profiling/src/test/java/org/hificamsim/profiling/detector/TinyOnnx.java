package org.hificamsim.profiling.detector;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * An ONNX network of three layers, written byte by byte as protocol buffers: each cell of 8 x 8
 * pixels answers with a box around itself, how red it is (class 0) and how blue (class 1), in the
 * form [1, 4 + 2, cells] of YOLO version 8.
 */
final class TinyOnnx {
  /** The width and height of its input, in pixels. */
  static final int SIZE = 64;

  private static final int CELL = 8;
  private static final int CELLS = SIZE / CELL;
  private static final int ANSWERS = 6;
  private static final int INT = 2;
  private static final int INTS = 7;

  private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

  private TinyOnnx() {}

  static byte[] network() {
    TinyOnnx graph =
        new TinyOnnx()
            .message(1, convolution())
            .message(1, node("Add", "reds", "places", "cells"))
            .message(1, node("Reshape", "cells", "form", "out"))
            .text(2, "tiny")
            .message(5, floats("weights", weights(), ANSWERS, 3, CELL, CELL))
            .message(5, floats("places", cellBoxes(), 1, ANSWERS, CELLS, CELLS))
            .message(5, longs("form", 1, ANSWERS, CELLS * CELLS))
            .message(11, value("in", 1, 3, SIZE, SIZE))
            .message(12, value("out", 1, ANSWERS, CELLS * CELLS));
    TinyOnnx opset = new TinyOnnx().text(1, "").number(2, 11);
    return new TinyOnnx().number(1, 6).message(8, opset).message(7, graph).bytes.toByteArray();
  }

  /**
   * The mean over a cell of red minus half of green and blue, and of blue minus half of the others.
   */
  private static float[] weights() {
    float[] weights = new float[ANSWERS * 3 * CELL * CELL];
    float share = 1f / (CELL * CELL);
    float[][] colours = {{share, -share / 2, -share / 2}, {-share / 2, -share / 2, share}};
    for (int c = 0; c < 2; c++) {
      for (int colour = 0; colour < 3; colour++) {
        int from = ((4 + c) * 3 + colour) * CELL * CELL;
        Arrays.fill(weights, from, from + CELL * CELL, colours[c][colour]);
      }
    }
    return weights;
  }

  /** Returns the centre of each cell and twice its size. */
  private static float[] cellBoxes() {
    float[] cellBoxes = new float[ANSWERS * CELLS * CELLS];
    for (int i = 0; i < CELLS * CELLS; i++) {
      cellBoxes[i] = CELL * (i % CELLS) + CELL / 2f;
      cellBoxes[CELLS * CELLS + i] = CELL * (i / CELLS) + CELL / 2f;
      cellBoxes[2 * CELLS * CELLS + i] = 2 * CELL;
      cellBoxes[3 * CELLS * CELLS + i] = 2 * CELL;
    }
    return cellBoxes;
  }

  private static TinyOnnx convolution() {
    return node("Conv", "in", "weights", "reds")
        .message(5, ints("kernel_shape"))
        .message(5, ints("strides"));
  }

  private static TinyOnnx node(String kind, String first, String second, String out) {
    return new TinyOnnx().text(1, first).text(1, second).text(2, out).text(3, out).text(4, kind);
  }

  private static TinyOnnx ints(String name) {
    return new TinyOnnx().text(1, name).number(8, CELL).number(8, CELL).number(20, INTS);
  }

  private static TinyOnnx floats(String name, float[] values, int... shape) {
    ByteBuffer raw = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
    raw.asFloatBuffer().put(values);
    return tensor(name, 1, raw.array(), shape);
  }

  private static TinyOnnx longs(String name, long... values) {
    ByteBuffer raw = ByteBuffer.allocate(8 * values.length).order(ByteOrder.LITTLE_ENDIAN);
    raw.asLongBuffer().put(values);
    return tensor(name, 7, raw.array(), values.length);
  }

  private static TinyOnnx tensor(String name, int type, byte[] raw, int... shape) {
    TinyOnnx tensor = new TinyOnnx();
    for (int length : shape) {
      tensor.number(1, length);
    }
    return tensor.number(2, type).text(8, name).field(9, raw);
  }

  private static TinyOnnx value(String name, int... shape) {
    TinyOnnx dimensions = new TinyOnnx();
    for (int length : shape) {
      dimensions.message(1, new TinyOnnx().number(1, length));
    }
    TinyOnnx tensor = new TinyOnnx().number(1, 1).message(2, dimensions);
    return new TinyOnnx().text(1, name).message(2, new TinyOnnx().message(1, tensor));
  }

  private TinyOnnx number(int field, long value) {
    varint((long) field << 3);
    varint(value);
    return this;
  }

  private TinyOnnx text(int field, String text) {
    return field(field, text.getBytes(StandardCharsets.UTF_8));
  }

  private TinyOnnx message(int field, TinyOnnx message) {
    return field(field, message.bytes.toByteArray());
  }

  private TinyOnnx field(int field, byte[] content) {
    varint(((long) field << 3) | INT);
    varint(content.length);
    bytes.writeBytes(content);
    return this;
  }

  private void varint(long value) {
    for (long rest = value; ; rest >>>= 7) {
      if (rest < 0x80) {
        bytes.write((int) rest);
        return;
      }
      bytes.write((int) ((rest & 0x7F) | 0x80));
    }
  }
}
