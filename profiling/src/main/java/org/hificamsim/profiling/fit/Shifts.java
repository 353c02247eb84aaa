package org.hificamsim.profiling.fit;

import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * What covariates do to the shares that one detector's g are asked at.
 *
 * @param all fitted to all photos
 * @param unseen fitted without each group
 * @param r2 of g on measured PIP, on what it has not seen; NaN without covariates
 * @param r2Alone the same without them
 */
public record Shifts(Shift all, List<Shift> unseen, double r2, double r2Alone) {
  /** No covariates. */
  static Shifts none(Groups groups) {
    List<Shift> none = Collections.nCopies(groups.count(), Shift.NONE);
    return new Shifts(Shift.NONE, none, Double.NaN, Double.NaN);
  }

  /** What a detector depends on, and what that is worth; empty without covariates. */
  public Optional<String> sentence(String detector) {
    return all.terms().isEmpty()
        ? Optional.empty()
        : Optional.of(
            String.format(
                Locale.ROOT,
                "%s depends on %s: R2 unseen %.3f on measured PIP, %.3f without%s",
                detector,
                all.terms().stream()
                    .map(term -> term.covariate().column())
                    .collect(Collectors.joining(" and ")),
                r2,
                r2Alone,
                r2 > r2Alone ? "" : "; that does not help"));
  }
}
