package org.hificamsim.hifi.detector;

/**
 * A detector model g: the confidence of a detector where the target fills a share of the image. An
 * extension point: another shape is a record here and a line in {@code DetectorFormats}.
 *
 * <p>Every shape but the line is monotone by construction: a larger target is never less sure.
 */
public interface DetectorModel {
  /** The confidence at a PIP of 0 or more, not clamped; NaN where the PIP is. */
  double confidence(double pip);

  /** The equation as people read it, with PIP as p. */
  String equation();
}
