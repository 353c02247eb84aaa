package org.hificamsim.hifi.detector;

/**
 * A detector model g: the confidence of a detector as a function of PIP, the share of the image
 * that the target fills. To add a shape, write a record in this package and a line in {@code
 * DetectorFormats}.
 *
 * <p>Every shape except the line is monotone by construction: confidence never falls with size.
 */
public interface DetectorModel {
  /** Returns the confidence at a PIP of 0 or more, not clamped to [0, 1]; NaN if the PIP is NaN. */
  double confidence(double pip);

  /** Returns the equation for readers, with PIP written as p. */
  String equation();
}
