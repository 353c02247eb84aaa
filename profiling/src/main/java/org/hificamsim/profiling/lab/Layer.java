package org.hificamsim.profiling.lab;

import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.MatOfPoint2f;
import org.opencv.core.Point;
import org.opencv.core.Rect;
import org.opencv.core.Scalar;
import org.opencv.core.Size;
import org.opencv.imgproc.Imgproc;

/**
 * Paints boards onto a canvas. Each is projected, blurred and blended within the part of the canvas
 * that it covers.
 */
final class Layer {
  private static final double GAMMA = 2.2;
  private static final int CORNERS = 4;

  private final Mat canvas;
  private final Pinhole camera;

  Layer(Mat canvas, Pinhole camera) {
    this.canvas = canvas;
    this.camera = camera;
  }

  /**
   * Paints a board.
   *
   * @param blur the diameter of the disc to which a point is blurred, in pixels
   */
  void paint(Board board, double blur) {
    Point[] corners = board.corners(camera);
    Rect part = part(corners, blur);
    if (part.empty()) {
      return;
    }
    try (Mats mats = new Mats()) {
      double span = span(corners);
      Mat shape = mats.own(shape(board, span));
      Mat colour = mats.own(colour(board.texture(), span));
      Mat coverage = warped(mats, shape, corners, part);
      Mat light = warped(mats, colour, corners, part);
      Mat coverageBgr = mats.mat();
      Imgproc.cvtColor(coverage, coverageBgr, Imgproc.COLOR_GRAY2BGR);
      Core.multiply(light, coverageBgr, light);
      LensBlur.apply(light, blur);
      LensBlur.apply(coverageBgr, blur);
      blend(mats, light, coverageBgr, mats.own(canvas.submat(part)));
    }
  }

  /** Returns the board's share of each pixel, [0, 1], without blur. */
  Mat silhouette(Board board) {
    Point[] corners = board.corners(camera);
    Rect whole = new Rect(0, 0, canvas.cols(), canvas.rows());
    try (Mats mats = new Mats()) {
      Mat shape = mats.own(shape(board, span(corners)));
      Mat coverage = warped(mats, shape, corners, whole);
      Mat copy = new Mat();
      coverage.copyTo(copy);
      return copy;
    }
  }

  private static void blend(Mats mats, Mat light, Mat coverage, Mat canvasPart) {
    Mat rest = mats.mat();
    Core.subtract(
        mats.own(new Mat(coverage.size(), coverage.type(), Scalar.all(1))), coverage, rest);
    Core.multiply(canvasPart, rest, canvasPart);
    Core.add(canvasPart, light, canvasPart);
  }

  /** Returns the texture in linear light, reduced to the resolution of the picture. */
  private static Mat colour(Mat texture, double span) {
    try (Mats mats = new Mats()) {
      Mat resized = fitted(mats, texture, span);
      Mat linear = new Mat();
      resized.convertTo(linear, CvType.CV_32F, 1.0 / 255);
      Core.pow(linear, GAMMA, linear);
      return linear;
    }
  }

  private static Mat fitted(Mats mats, Mat texture, double span) {
    int side = (int) Math.max(2, Math.round(span));
    if (side >= texture.cols()) {
      return texture;
    }
    Mat small = mats.mat();
    Imgproc.resize(texture, small, new Size(side, side), 0, 0, Imgproc.INTER_AREA);
    return small;
  }

  private static Mat shape(Board board, double span) {
    int side = (int) Math.max(CORNERS, Math.min(2048, Math.round(span)));
    if (!board.round()) {
      return new Mat(side, side, CvType.CV_32F, new Scalar(1));
    }
    Mat shape = Mat.zeros(side, side, CvType.CV_32F);
    int subpixels = 16;
    int half = side * subpixels / 2;
    Imgproc.circle(
        shape, new Point(half, half), half, new Scalar(1), Core.FILLED, Imgproc.LINE_8, 4);
    return shape;
  }

  /** Projects the surface onto a part of the canvas. */
  private static Mat warped(Mats mats, Mat surface, Point[] corners, Rect part) {
    double right = surface.cols() - 0.5;
    double bottom = surface.rows() - 0.5;
    MatOfPoint2f from =
        mats.own(
            new MatOfPoint2f(
                new Point(-0.5, -0.5),
                new Point(right, -0.5),
                new Point(right, bottom),
                new Point(-0.5, bottom)));
    Point[] moved = new Point[CORNERS];
    for (int i = 0; i < CORNERS; i++) {
      moved[i] = new Point(corners[i].x - part.x - 0.5, corners[i].y - part.y - 0.5);
    }
    Mat homography =
        mats.own(Imgproc.getPerspectiveTransform(from, mats.own(new MatOfPoint2f(moved))));
    Mat resized = mats.mat();
    int border = surface.channels() == 1 ? Core.BORDER_CONSTANT : Core.BORDER_REPLICATE;
    Imgproc.warpPerspective(
        surface, resized, homography, part.size(), Imgproc.INTER_LINEAR, border, new Scalar(0));
    return resized;
  }

  /** Returns the part of the canvas that a blurred board may touch. */
  private Rect part(Point[] corners, double blur) {
    double margin = blur + 2;
    double left = canvas.cols();
    double top = canvas.rows();
    double right = 0;
    double bottom = 0;
    for (Point corner : corners) {
      left = Math.min(left, corner.x - margin);
      top = Math.min(top, corner.y - margin);
      right = Math.max(right, corner.x + margin);
      bottom = Math.max(bottom, corner.y + margin);
    }
    int x = (int) Math.max(0, Math.floor(left));
    int y = (int) Math.max(0, Math.floor(top));
    int endX = (int) Math.min(canvas.cols(), Math.ceil(right));
    int endY = (int) Math.min(canvas.rows(), Math.ceil(bottom));
    return new Rect(x, y, Math.max(0, endX - x), Math.max(0, endY - y));
  }

  /** Returns the length of the board's longest edge on the canvas, in pixels. */
  private static double span(Point[] corners) {
    double widest = 0;
    for (int i = 0; i < CORNERS; i++) {
      Point next = corners[(i + 1) % CORNERS];
      widest = Math.max(widest, Math.hypot(next.x - corners[i].x, next.y - corners[i].y));
    }
    return widest;
  }
}
