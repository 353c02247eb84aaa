package org.hificamsim.profiling.fit;

import java.util.List;
import org.hificamsim.profiling.dataset.Covariate;
import org.hificamsim.profiling.measure.Measurement;

/**
 * What covariates do to the share of the image that g is asked at: a photo's counts {@code exp(sum
 * weight (value - mean))} times as large. So g still rises with size, and what it says of an empty
 * and of a full image stays.
 *
 * @param terms one for each covariate; none where g is asked at the share itself
 */
public record Shift(List<Term> terms) {
  /** No covariates. */
  public static final Shift NONE = new Shift(List.of());

  /**
   * What one covariate adds to the natural logarithm of the share.
   *
   * @param weight for a unit of it
   * @param mean of all photos, where nothing is added
   */
  public record Term(Covariate covariate, double weight, double mean) {}

  public Shift {
    terms = List.copyOf(terms);
  }

  /** How many times as large a photo's share counts. */
  public double factor(Measurement photo) {
    double sum = 0;
    for (Term term : terms) {
      sum += term.weight() * (photo.covariates().get(term.covariate()) - term.mean());
    }
    return StrictMath.exp(sum);
  }

  /** The shares at which g is asked. */
  public double[] applied(double[] pip, List<Measurement> photos) {
    double[] shifted = pip.clone();
    if (!terms.isEmpty()) {
      for (int i = 0; i < pip.length; i++) {
        shifted[i] *= factor(photos.get(i));
      }
    }
    return shifted;
  }
}
