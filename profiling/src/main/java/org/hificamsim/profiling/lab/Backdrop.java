package org.hificamsim.profiling.lab;

import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Scalar;
import org.opencv.core.Size;
import org.opencv.imgproc.Imgproc;

/**
 * The far wall of the room: value noise of many sizes that is fixed to the wall, so that zooming in
 * shows finer detail of the same wall.
 *
 * @param distance of the wall, metres
 * @param seed of its pattern
 */
record Backdrop(double distance, long seed) {
  private static final double COARSEST = 2.4;
  private static final int OCTAVES = 9;
  private static final double MAX_CELL = 32;

  /** Fills a canvas (32 bits, BGR, linear light) with what the camera sees of the bare wall. */
  void paint(Mat canvas, Pinhole camera) {
    canvas.setTo(new Scalar(0.30, 0.33, 0.36));
    double strength = 0.055;
    double cell = COARSEST;
    for (int octave = 0; octave < OCTAVES; octave++) {
      double pixels = cell * camera.magnification(distance);
      if (pixels >= 1.5) {
        add(canvas, pixels, strength, octave);
      }
      cell /= 2;
      strength *= 0.72;
    }
  }

  /** Adds one octave, drawn small where its cells are large, since warping knows 1/32 pixel. */
  private void add(Mat canvas, double pixels, double strength, int octave) {
    double shrink = Math.min(1, MAX_CELL / pixels);
    Size size =
        new Size(Math.ceil(canvas.cols() * shrink) + 1, Math.ceil(canvas.rows() * shrink) + 1);
    double step = pixels * shrink;
    try (Mats mats = new Mats()) {
      int across = (int) Math.ceil(size.width / step / 2) + 2;
      int down = (int) Math.ceil(size.height / step / 2) + 2;
      Mat affine = mats.own(new Mat(2, 3, CvType.CV_64F));
      double left = size.width / 2 - across * step;
      double top = size.height / 2 - down * step;
      affine.put(0, 0, step, 0, left, 0, step, top);
      Mat small = mats.mat();
      Imgproc.warpAffine(
          lattice(mats, across, down, strength, octave), small, affine, size, Imgproc.INTER_CUBIC);
      Mat layer = mats.mat();
      Imgproc.resize(small, layer, canvas.size(), 0, 0, Imgproc.INTER_CUBIC);
      Mat colour = mats.mat();
      Imgproc.cvtColor(layer, colour, Imgproc.COLOR_GRAY2BGR);
      Core.add(canvas, colour, canvas);
    }
  }

  private Mat lattice(Mats mats, int across, int down, double strength, int octave) {
    float[] row = new float[2 * across + 1];
    Mat lattice = mats.own(new Mat(2 * down + 1, row.length, CvType.CV_32F));
    for (int y = -down; y <= down; y++) {
      for (int x = -across; x <= across; x++) {
        row[x + across] = (float) (strength * value(x, y, octave));
      }
      lattice.put(y + down, 0, row);
    }
    return lattice;
  }

  /** A value in [-1, 1) of a lattice point, from its hash (SplitMix64's finalizer). */
  private double value(int x, int y, int octave) {
    long h =
        seed + 0x9E3779B97F4A7C15L * (x * 73_856_093L ^ y * 19_349_663L ^ octave * 83_492_791L);
    h = (h ^ (h >>> 30)) * 0xBF58476D1CE4E5B9L;
    h = (h ^ (h >>> 27)) * 0x94D049BB133111EBL;
    return (h ^ (h >>> 31)) * 0x1p-63;
  }
}
