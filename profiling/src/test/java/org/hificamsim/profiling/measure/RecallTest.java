package org.hificamsim.profiling.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class RecallTest {
  /** Heights are 1 to 100. Objects are found from 51 on, and at every tenth height below. */
  @Test
  void recallIsTheShareFoundAtSimilarHeight() {
    List<Measurement> rows = new ArrayList<>();
    int[] heights = new int[100];
    for (int i = 0; i < 100; i++) {
      heights[i] = 100 - i;
      rows.add(row(heights[i] > 50 || heights[i] % 10 == 0 ? 0.4 : 0));
    }
    List<Measurement> withRecall = Recall.with(rows, heights, "onnx-tiny-0");
    for (int i = 0; i < 100; i++) {
      assertEquals(
          heights[i] > 50 ? 1 : 0.1, withRecall.get(i).confidence("onnx-tiny-0-recall"), 1e-12);
      assertEquals(
          rows.get(i).confidence("onnx-tiny-0"), withRecall.get(i).confidence("onnx-tiny-0"));
    }
  }

  @Test
  void objectsOfOneHeightHaveOneRecall() {
    List<Measurement> rows = new ArrayList<>();
    for (int i = 0; i < 20; i++) {
      rows.add(row(i % 2));
    }
    int[] heights = new int[20];
    Arrays.fill(heights, 80);
    Recall.with(rows, heights, "onnx-tiny-0")
        .forEach(row -> assertEquals(0.5, row.confidence("onnx-tiny-0-recall")));
  }

  private static Measurement row(double confidence) {
    return new Measurement("a", "person", 1, 1, 0.05, 0.1, Map.of("onnx-tiny-0", confidence));
  }
}
