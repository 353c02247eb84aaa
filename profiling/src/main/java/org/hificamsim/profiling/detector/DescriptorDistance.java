package org.hificamsim.profiling.detector;

import org.opencv.core.Core;

/** How far apart two descriptors are. */
public enum DescriptorDistance {
  /** The root of the summed squares, as the thesis has it for all detectors (thesis 5.3). */
  EUCLIDEAN(Core.NORM_L2),
  /** The number of bits that differ; for ORB, the others keep the Euclidean distance. */
  HAMMING(Core.NORM_HAMMING);

  private final int norm;

  DescriptorDistance(int norm) {
    this.norm = norm;
  }

  /** OpenCV's norm for descriptors of this depth: bits exist in 8-bit ones alone. */
  int norm(boolean bits) {
    return bits ? norm : Core.NORM_L2;
  }
}
