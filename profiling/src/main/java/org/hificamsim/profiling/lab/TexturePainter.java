package org.hificamsim.profiling.lab;

import java.util.List;
import java.util.random.RandomGenerator;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.MatOfPoint;
import org.opencv.core.Point;
import org.opencv.core.Scalar;
import org.opencv.core.Size;
import org.opencv.imgproc.Imgproc;

/** Paints textures: random shapes, words and grain, the same for the same random numbers. */
final class TexturePainter {
  private static final double FINEST_GRAIN = 1.0 / 200;

  private final Mat canvas;
  private final int side;
  private final RandomGenerator random;

  private TexturePainter(Mat canvas, RandomGenerator random) {
    this.canvas = canvas;
    this.side = canvas.cols();
    this.random = random;
  }

  /** A square texture (8 bits, BGR) of this many pixels a side; the caller releases it. */
  static Mat paint(Pattern pattern, int side, RandomGenerator random) {
    Mat canvas = new Mat(side, side, CvType.CV_8UC3);
    new TexturePainter(canvas, random).paint(pattern);
    return canvas;
  }

  private void paint(Pattern pattern) {
    canvas.setTo(colour());
    repeat(pattern.polygons(), this::polygon);
    repeat(pattern.rectangles(), this::rectangle);
    repeat(pattern.circles(), this::circle);
    repeat(pattern.lines(), this::line);
    repeat(pattern.words(), this::word);
    grain(pattern.grain());
  }

  private static void repeat(int times, Runnable shape) {
    for (int i = 0; i < times; i++) {
      shape.run();
    }
  }

  private void polygon() {
    Point centre = point();
    double radius = side * random.nextDouble(0.03, 0.16);
    double start = random.nextDouble(2 * Math.PI);
    int corners = random.nextInt(3, 7);
    Point[] points = new Point[corners];
    for (int i = 0; i < corners; i++) {
      double angle = start + 2 * Math.PI * i / corners;
      double reach = radius * random.nextDouble(0.6, 1);
      points[i] =
          new Point(
              centre.x + reach * StrictMath.cos(angle), centre.y + reach * StrictMath.sin(angle));
    }
    MatOfPoint outline = new MatOfPoint(points);
    Imgproc.fillPoly(canvas, List.of(outline), colour(), Imgproc.LINE_AA);
    outline.release();
  }

  private void rectangle() {
    Point corner = point();
    Point opposite =
        new Point(
            corner.x + side * random.nextDouble(0.02, 0.22),
            corner.y + side * random.nextDouble(0.02, 0.14));
    Imgproc.rectangle(canvas, corner, opposite, colour(), Core.FILLED);
  }

  private void circle() {
    int radius = (int) (side * random.nextDouble(0.012, 0.07));
    Imgproc.circle(canvas, point(), radius, colour(), Core.FILLED, Imgproc.LINE_AA);
  }

  private void line() {
    int thickness = Math.max(1, (int) (side * random.nextDouble(0.003, 0.012)));
    Imgproc.line(canvas, point(), point(), colour(), thickness, Imgproc.LINE_AA);
  }

  private void word() {
    StringBuilder word = new StringBuilder();
    for (int letters = random.nextInt(3, 9); letters > 0; letters--) {
      word.append((char) ('A' + random.nextInt(26)));
    }
    double height = side * random.nextDouble(0.0012, 0.004);
    int thickness = Math.max(1, (int) (height * 1.6));
    Point at = new Point(random.nextDouble(-0.1, 0.8) * side, random.nextDouble(1.0) * side);
    Imgproc.putText(
        canvas,
        word.toString(),
        at,
        Imgproc.FONT_HERSHEY_DUPLEX,
        height,
        colour(),
        thickness,
        Imgproc.LINE_AA);
  }

  /** Adds grain of two sizes, painted small and enlarged. */
  private void grain(double strength) {
    if (strength == 0) {
      return;
    }
    for (double cell : new double[] {FINEST_GRAIN, 5 * FINEST_GRAIN}) {
      try (Mats mats = new Mats()) {
        int cells = (int) Math.round(1 / cell);
        Mat noise = mats.own(new Mat(cells, cells, CvType.CV_16SC1));
        Core.setRNGSeed(random.nextInt());
        Core.randn(noise, 0, 255 * strength);
        Mat large = mats.mat();
        Imgproc.resize(noise, large, new Size(side, side), 0, 0, Imgproc.INTER_CUBIC);
        Mat grey = mats.mat();
        Core.merge(List.of(large, large, large), grey);
        Core.add(canvas, grey, canvas, mats.mat(), CvType.CV_8U);
      }
    }
  }

  private Point point() {
    return new Point(random.nextDouble(side), random.nextDouble(side));
  }

  private Scalar colour() {
    return new Scalar(
        random.nextDouble(10, 245), random.nextDouble(10, 245), random.nextDouble(10, 245));
  }
}
