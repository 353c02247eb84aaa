package org.hificamsim.profiling.fit;

/**
 * What an epsilon support vector regression is trained with (Eq 4.8).
 *
 * @param epsilon half the width of the tube whose errors cost nothing
 * @param penalty C, what an error beyond it costs
 * @param tolerance when the optimisation stops
 */
public record SupportVectorSettings(double epsilon, double penalty, double tolerance) {
  /** The thesis's epsilon and C (thesis 4.5.3), and LIBSVM's tolerance. */
  public static final SupportVectorSettings THESIS = new SupportVectorSettings(0.1, 1, 1e-3);
}
