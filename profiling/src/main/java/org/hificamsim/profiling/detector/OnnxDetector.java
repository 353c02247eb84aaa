package org.hificamsim.profiling.detector;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.registry.Options;
import org.hificamsim.profiling.detector.BoxDetector.Box;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Core;
import org.opencv.core.CvException;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Scalar;
import org.opencv.core.Size;
import org.opencv.dnn.Dnn;
import org.opencv.dnn.Net;
import org.opencv.imgproc.Imgproc;

/**
 * A network in an ONNX file. Its input is the photo in red, green and blue from 0 to 1, scaled into
 * a square with grey borders. Its output is {@code [1, N, 5 + classes]} (centre, size, objectness,
 * classes: YOLO up to version 7), {@code [1, 4 + classes, N]} (without objectness: version 8 and
 * later), or {@code [1, 1, N, 7]} (picture, class, score and corners from 0 to 1: SSD). The layout
 * is recognised by having more boxes than numbers per box.
 */
final class OnnxDetector implements BoxDetector {
  /** The prefix of the names of such detectors. */
  static final String PREFIX = "onnx:";

  private static final double GREY = 114;
  private static final int SSD_NUMBERS = 7;
  private static final int OBJECTNESS_INDEX = 4;

  /**
   * A network with its options: {@code onnx:FILE[:class=N][:size=N][:threshold=X]}.
   *
   * @param category the index of the class to find, from 0
   * @param size the width and height of its input, in pixels
   * @param threshold the least score that counts, [0, 1]
   */
  record Network(Path file, int category, int size, double threshold) {
    /**
     * Parses a name.
     *
     * @throws InputException in one line, when the options or the file are wrong
     */
    static Network of(String name) {
      String text = name.substring(PREFIX.length()).replace(':', ',');
      Options options = Options.parse(setting("detectors") + " has '" + name + "'", text);
      Network read =
          new Network(
              Path.of(options.mainText("file", "", "the network")),
              options.integer("class", 0, 0, 1_000_000, "which of its classes, from 0"),
              options.integer("size", 640, 8, 8192, "of its input, pixels a side"),
              options.number("threshold", 0.25, 0, 1, "the least score that counts"));
      options.rejectUnknown();
      if (!Files.isRegularFile(read.file)) {
        throw new InputException(read.file + ": no such file, expected an ONNX network");
      }
      return read;
    }

    /** Returns the name of its column. */
    String column() {
      String stem = file.getFileName().toString().replaceFirst("\\.[^.]*$", "");
      return "onnx-" + stem.replaceAll("[^A-Za-z0-9_]", "-") + "-" + category;
    }
  }

  private final Network network;
  private final Net net;

  OnnxDetector(Network network) {
    this.network = network;
    try {
      this.net = Dnn.readNetFromONNX(network.file().toString());
    } catch (CvException e) {
      throw failed(e);
    }
  }

  @Override
  public String name() {
    return network.column();
  }

  @Override
  public List<Box> detect(Photograph photo) {
    Mat picture = photo.colour();
    double scale = network.size() / (double) Math.max(picture.cols(), picture.rows());
    try (Mats mats = new Mats()) {
      net.setInput(mats.own(blob(mats, picture, scale)));
      List<Mat> outputs = new ArrayList<>();
      net.forward(outputs, net.getUnconnectedOutLayersNames());
      outputs.forEach(mats::own);
      List<Box> boxes = boxes(network, outputs.get(0));
      return boxes.stream().map(box -> inPhoto(box, scale)).toList();
    } catch (CvException e) {
      throw failed(e);
    }
  }

  private Mat blob(Mats mats, Mat picture, double scale) {
    Mat small = mats.mat();
    Size fitted =
        new Size(
            Math.max(1, Math.round(picture.cols() * scale)),
            Math.max(1, Math.round(picture.rows() * scale)));
    Imgproc.resize(picture, small, fitted, 0, 0, scale < 1 ? Imgproc.INTER_AREA : 1);
    Mat square = mats.mat();
    Core.copyMakeBorder(
        small,
        square,
        0,
        network.size() - small.rows(),
        0,
        network.size() - small.cols(),
        Core.BORDER_CONSTANT,
        Scalar.all(GREY));
    return Dnn.blobFromImage(
        square, 1.0 / 255, square.size(), new Scalar(0), true, false, CvType.CV_32F);
  }

  private static Box inPhoto(Box box, double scale) {
    return new Box(
        box.x() / scale, box.y() / scale, box.width() / scale, box.height() / scale, box.score());
  }

  /** Returns the boxes of the requested class, in pixels of the network's input. */
  static List<Box> boxes(Network network, Mat output) {
    float[] values = new float[(int) output.total()];
    output.get(new int[output.dims()], values);
    List<Box> boxes = new ArrayList<>();
    if (output.dims() == 4 && output.size(3) == SSD_NUMBERS) {
      addFromCorners(network, values, boxes);
    } else if (output.dims() == 3) {
      addFromCentres(network, values, output.size(1), output.size(2), boxes);
    } else {
      throw InputException.of(
          "%s: the network's answer has %s dimensions, expected [1, N, 5 + classes], [1,"
              + " 4 + classes, N] or [1, 1, N, 7]",
          network.file(), output.dims());
    }
    return boxes;
  }

  private static void addFromCentres(
      Network network, float[] values, int rows, int columns, List<Box> boxes) {
    boolean boxesInColumns = rows < columns;
    int count = boxesInColumns ? columns : rows;
    int numbers = boxesInColumns ? rows : columns;
    int firstClass = boxesInColumns ? OBJECTNESS_INDEX : OBJECTNESS_INDEX + 1;
    checkClass(network, numbers - firstClass);
    for (int i = 0; i < count; i++) {
      int start = boxesInColumns ? i : i * columns;
      int step = boxesInColumns ? columns : 1;
      double score = values[start + (firstClass + network.category()) * step];
      score *= boxesInColumns ? 1 : values[start + OBJECTNESS_INDEX * step];
      double width = values[start + 2 * step];
      double height = values[start + 3 * step];
      add(
          network,
          values[start] - width / 2,
          values[start + step] - height / 2,
          width,
          height,
          score,
          boxes);
    }
  }

  private static void addFromCorners(Network network, float[] values, List<Box> boxes) {
    for (int i = 0; i < values.length; i += SSD_NUMBERS) {
      if (values[i + 1] == network.category()) {
        double left = values[i + 3] * network.size();
        double top = values[i + 4] * network.size();
        double right = values[i + 5] * network.size();
        double bottom = values[i + 6] * network.size();
        add(network, left, top, right - left, bottom - top, values[i + 2], boxes);
      }
    }
  }

  private static void add(
      Network network, double x, double y, double w, double h, double score, List<Box> boxes) {
    if (score > 0 && score >= network.threshold() && w > 0 && h > 0) {
      boxes.add(new Box(x, y, w, h, Math.min(1, score)));
    }
  }

  private static void checkClass(Network network, int classes) {
    if (network.category() >= classes) {
      throw InputException.of(
          "%s: class is %s, expected one of the network's %s, from 0",
          network.file(), network.category(), classes);
    }
  }

  private InputException failed(CvException e) {
    String reason =
        Collections.max(e.getMessage().lines().toList(), Comparator.comparingInt(String::length))
            .strip();
    return new InputException(
        network.file() + ": OpenCV cannot run the network, expected ONNX of a detector: " + reason,
        e);
  }
}
