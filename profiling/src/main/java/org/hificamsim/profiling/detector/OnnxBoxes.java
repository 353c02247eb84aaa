package org.hificamsim.profiling.detector;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.detector.BoxDetector.Box;
import org.opencv.core.Mat;

/**
 * Reads the answer of a network: {@code [1, N, 5 + classes]} (centre, size, objectness, classes:
 * YOLO up to version 7), {@code [1, 4 + classes, N]} (without objectness: version 8 and later), or
 * {@code [1, 1, N, 7]} (picture, class, score and corners from 0 to 1: SSD). There are more boxes
 * than numbers of each.
 */
record OnnxBoxes(OnnxOptions options) {
  private static final int SSD = 7;
  private static final int OBJECTNESS = 4;

  /** The boxes of the class that is asked for, in pixels of the network's input. */
  List<Box> of(Mat answer) {
    float[] values = new float[(int) answer.total()];
    answer.get(new int[answer.dims()], values);
    List<Box> boxes = new ArrayList<>();
    if (answer.dims() == 4 && answer.size(3) == SSD) {
      corners(values, boxes);
    } else if (answer.dims() == 3) {
      centres(values, answer.size(1), answer.size(2), boxes);
    } else {
      throw InputException.of(
          "%s: the network's answer has %s dimensions, expected [1, N, 5 + classes], [1,"
              + " 4 + classes, N] or [1, 1, N, 7]",
          options.file(), answer.dims());
    }
    return boxes;
  }

  private void centres(float[] values, int rows, int columns, List<Box> boxes) {
    boolean across = rows < columns;
    int count = across ? columns : rows;
    int numbers = across ? rows : columns;
    int first = across ? OBJECTNESS : OBJECTNESS + 1;
    checkClass(numbers - first);
    for (int i = 0; i < count; i++) {
      int start = across ? i : i * columns;
      int step = across ? columns : 1;
      double score = values[start + (first + options.category()) * step];
      score *= across ? 1 : values[start + OBJECTNESS * step];
      double width = values[start + 2 * step];
      double height = values[start + 3 * step];
      add(
          values[start] - width / 2,
          values[start + step] - height / 2,
          width,
          height,
          score,
          boxes);
    }
  }

  private void corners(float[] values, List<Box> boxes) {
    for (int i = 0; i < values.length; i += SSD) {
      if (values[i + 1] == options.category()) {
        double left = values[i + 3] * options.size();
        double top = values[i + 4] * options.size();
        double right = values[i + 5] * options.size();
        double bottom = values[i + 6] * options.size();
        add(left, top, right - left, bottom - top, values[i + 2], boxes);
      }
    }
  }

  private void add(double x, double y, double w, double h, double score, List<Box> boxes) {
    if (score > 0 && score >= options.threshold() && w > 0 && h > 0) {
      boxes.add(new Box(x, y, w, h, Math.min(1, score)));
    }
  }

  private void checkClass(int classes) {
    if (options.category() >= classes) {
      throw InputException.of(
          "%s: class is %s, expected one of the network's %s, from 0",
          options.file(), options.category(), classes);
    }
  }
}
