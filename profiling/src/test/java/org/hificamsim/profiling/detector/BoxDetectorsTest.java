package org.hificamsim.profiling.detector;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.dataset.Patch;
import org.hificamsim.profiling.detector.BoxDetector.Box;
import org.hificamsim.profiling.detector.ConfidenceSource.Subject;
import org.hificamsim.profiling.opencv.Mats;
import org.hificamsim.profiling.opencv.OpenCv;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Rect;
import org.opencv.core.Scalar;
import org.opencv.imgcodecs.Imgcodecs;

/** Tests box detectors on pictures drawn for them. */
class BoxDetectorsTest {
  private static final Scalar RED = new Scalar(0, 0, 255);
  private static final Scalar BLUE = new Scalar(255, 0, 0);

  @TempDir Path folder;

  @BeforeAll
  static void load() {
    OpenCv.load();
  }

  @Test
  void networkFindsOnlyItsClass() throws IOException {
    Path network = folder.resolve("tiny.onnx");
    Files.write(network, TinyOnnx.network());
    Path photo =
        picture(128, 96, Scalar.all(0), canvas -> fill(canvas, new Rect(32, 24, 32, 32), RED));
    String red = "onnx:" + network + ":class=0:size=" + TinyOnnx.SIZE;
    assertEquals("onnx-tiny-0", Detectors.column(red));
    Patch there = new Patch(32, 24, 32, 32);
    assertEquals(1, confidence(red, photo, there), 0.01);
    assertEquals(0, confidence(red, photo, new Patch(90, 60, 32, 32)));
    String blue = "onnx:" + network + ":class=1:size=" + TinyOnnx.SIZE;
    assertEquals(0, falseConfidence(blue, photo));
    Path bluePhoto =
        picture(128, 96, Scalar.all(0), canvas -> fill(canvas, new Rect(32, 24, 32, 32), BLUE));
    assertEquals(1, confidence(blue, bluePhoto, there), 0.01);
  }

  @Test
  void rejectsNetworkWithoutTheClass() throws IOException {
    Path network = folder.resolve("tiny.onnx");
    Files.write(network, TinyOnnx.network());
    Path photo = picture(128, 96, RED, canvas -> {});
    String message =
        assertThrows(
                InputException.class,
                () -> falseConfidence("onnx:" + network + ":class=2:size=64", photo))
            .getMessage();
    assertEquals(network + ": class is 2, expected one of the network's 2, from 0", message);
  }

  @Test
  void rejectsFileWithoutANetworkInOneLine() throws IOException {
    Path network = folder.resolve("no.onnx");
    Files.writeString(network, "no network");
    String message =
        assertThrows(
                InputException.class,
                () -> falseConfidence("onnx:" + network, picture(64, 64, RED, canvas -> {})))
            .getMessage();
    assertTrue(message.startsWith(network + ": OpenCV cannot run the network"), message);
    assertEquals(1, message.lines().count(), message);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"yolo", "haar:nix", "onnx:FILE:class=x", "onnx:FILE:size=4", "onnx:FILE:nix=1"})
  void rejectsInvalidDetectorsWithExpectation(String name) throws IOException {
    Path network = folder.resolve("some.onnx");
    Files.write(network, TinyOnnx.network());
    String text = name.replace("FILE", network.toString());
    String message = assertThrows(InputException.class, () -> Detectors.column(text)).getMessage();
    assertTrue(message.startsWith("detectors has '" + text + "'"), message);
    assertTrue(message.contains(", expected "), message);
  }

  @Test
  void readsOutputOfOlderYoloNetworks() {
    OnnxDetector.Network second = new OnnxDetector.Network(Path.of("x.onnx"), 1, 100, 0.25);
    Mat answer = new Mat(new int[] {1, 8, 7}, CvType.CV_32F, new Scalar(0));
    answer.put(new int[] {0, 2, 0}, new float[] {50, 40, 20, 10, 0.8f, 0.1f, 0.9f});
    answer.put(new int[] {0, 3, 0}, new float[] {50, 40, 20, 10, 0.2f, 0.1f, 0.9f});
    List<Box> boxes = OnnxDetector.boxes(second, answer);
    assertEquals(1, boxes.size(), boxes.toString());
    assertBox(40, 35, 20, 10, 0.72, boxes.get(0));
  }

  @Test
  void readsOutputOfSsdNetworks() {
    OnnxDetector.Network third = new OnnxDetector.Network(Path.of("x.onnx"), 2, 100, 0.25);
    Mat answer = new Mat(new int[] {1, 1, 2, 7}, CvType.CV_32F, new Scalar(0));
    answer.put(new int[] {0, 0, 0, 0}, new float[] {0, 1, 0.9f, 0, 0, 1, 1});
    answer.put(new int[] {0, 0, 1, 0}, new float[] {0, 2, 0.6f, 0.1f, 0.2f, 0.4f, 0.6f});
    List<Box> boxes = OnnxDetector.boxes(third, answer);
    assertEquals(1, boxes.size(), boxes.toString());
    assertBox(10, 20, 30, 40, 0.6, boxes.get(0));
  }

  private static void assertBox(
      double x, double y, double width, double height, double score, Box box) {
    assertEquals(x, box.x(), 1e-4);
    assertEquals(y, box.y(), 1e-4);
    assertEquals(width, box.width(), 1e-4);
    assertEquals(height, box.height(), 1e-4);
    assertEquals(score, box.score(), 1e-6);
  }

  private static double confidence(String detector, Path file, Patch patch) {
    return ask(detector, file, patch, true);
  }

  private static double falseConfidence(String detector, Path file) {
    return ask(detector, file, new Patch(0, 0, 1, 1), false);
  }

  private static double ask(String detector, Path file, Patch patch, boolean shown) {
    ConfidenceSource source =
        Detectors.sources(
                List.of(detector), RatioTest.THESIS, new Templates(Map.of(), List.of(), 1))
            .get(0);
    try (Photograph photo = new Photograph(file)) {
      List<Subject> subjects = List.of(new Subject("thing", patch));
      return source.confidences(photo, subjects, shown).get(0).get(Detectors.column(detector));
    }
  }

  private interface Drawing {
    void on(Mat canvas);
  }

  private Path picture(int width, int height, Scalar background, Drawing drawing) {
    Path file = folder.resolve("picture-" + System.nanoTime() + ".png");
    try (Mats mats = new Mats()) {
      Mat canvas = mats.own(new Mat(height, width, CvType.CV_8UC3, background));
      drawing.on(canvas);
      Imgcodecs.imwrite(file.toString(), canvas);
    }
    return file;
  }

  private static void fill(Mat canvas, Rect part, Scalar colour) {
    canvas.submat(part).setTo(colour);
  }
}
