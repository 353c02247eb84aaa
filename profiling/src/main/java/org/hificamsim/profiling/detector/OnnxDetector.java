package org.hificamsim.profiling.detector;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import org.hificamsim.core.InputException;
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
 * A network in an ONNX file. It is shown the photo in a square, shrunk or enlarged with its sides
 * in proportion and grey around it, red, green and blue from 0 to 1; {@link OnnxBoxes} reads its
 * answer.
 */
final class OnnxDetector implements BoxDetector {
  private static final double GREY = 114;

  private final OnnxOptions options;
  private final Net net;

  OnnxDetector(OnnxOptions options) {
    this.options = options;
    try {
      this.net = Dnn.readNetFromONNX(options.file().toString());
    } catch (CvException e) {
      throw failed(e);
    }
  }

  @Override
  public List<Box> detect(Photograph photo) {
    Mat picture = photo.colour();
    double scale = options.size() / (double) Math.max(picture.cols(), picture.rows());
    try (Mats mats = new Mats()) {
      net.setInput(mats.own(blob(mats, picture, scale)));
      List<Mat> answers = new ArrayList<>();
      net.forward(answers, net.getUnconnectedOutLayersNames());
      answers.forEach(mats::own);
      List<Box> boxes = new OnnxBoxes(options).of(answers.get(0));
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
        options.size() - small.rows(),
        0,
        options.size() - small.cols(),
        Core.BORDER_CONSTANT,
        Scalar.all(GREY));
    return Dnn.blobFromImage(
        square, 1.0 / 255, square.size(), new Scalar(0), true, false, CvType.CV_32F);
  }

  private static Box inPhoto(Box box, double scale) {
    return new Box(
        box.x() / scale, box.y() / scale, box.width() / scale, box.height() / scale, box.score());
  }

  private InputException failed(CvException e) {
    String reason =
        Collections.max(e.getMessage().lines().toList(), Comparator.comparingInt(String::length))
            .strip();
    return new InputException(
        options.file() + ": OpenCV cannot run the network, expected ONNX of a detector: " + reason,
        e);
  }
}
