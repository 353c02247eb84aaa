package org.hificamsim.hifi.feature;

import com.fasterxml.jackson.annotation.JsonProperty;

/**
 * A formula in z, q and d for {@code -log10(PIP)}, as symbolic regression finds it: Eq 4.5.
 *
 * @param expression the formula
 */
public record SymbolicAbstraction(@JsonProperty("formula") Expression expression)
    implements LogPipAbstraction {
  @Override
  public double negativeLogPip(double size, double distance, double focalLength) {
    return expression.value(size, distance, focalLength);
  }
}
