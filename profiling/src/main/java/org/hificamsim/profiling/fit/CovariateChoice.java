package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.dataset.Covariate;
import org.hificamsim.profiling.measure.Measurement;

/**
 * Which covariates the models have: those that are named, or for each detector those that help on
 * what was not seen.
 *
 * @param named taken whether they help or not
 * @param best whether those that help are taken
 */
public record CovariateChoice(List<Covariate> named, boolean best) {
  /** None. */
  public static final CovariateChoice NONE = new CovariateChoice(List.of(), false);

  private static final String BEST = "best";

  /**
   * What a user asks for.
   *
   * @param names none, best, or names of columns
   * @throws InputException when there is none of a name that a scenario could give
   */
  public static CovariateChoice of(List<String> names) {
    if (names.equals(List.of("none"))) {
      return NONE;
    }
    return names.equals(List.of(BEST))
        ? new CovariateChoice(List.of(), true)
        : new CovariateChoice(
            names.stream().map(CovariateChoice::covariate).distinct().sorted().toList(), false);
  }

  private static Covariate covariate(String name) {
    return Covariate.given().stream()
        .filter(one -> one.column().equals(name))
        .findFirst()
        .orElseThrow(
            () ->
                new InputException(
                    "covariate '%s' is unknown, expected none, best, or some of %s"
                        .formatted(name, columns(Covariate.given()))));
  }

  /** Whether there may be any. */
  boolean any() {
    return best || !named.isEmpty();
  }

  /** Those that every photo has, and that vary. */
  static List<Covariate> known(List<Measurement> photos) {
    return Arrays.stream(Covariate.values())
        .filter(one -> photos.stream().allMatch(m -> m.covariates().containsKey(one)))
        .filter(one -> Scores.vary(ShiftFitting.values(one, photos)))
        .toList();
  }

  /**
   * Chooses for one detector.
   *
   * @param alone its g on measured PIP
   */
  ShiftedFit of(ShapeFit alone, List<Measurement> photos, double[] confidences, Groups groups) {
    ShiftedFit plain = ShiftedFit.plain(groups, alone);
    return best
        ? forward(plain, ofScenarios(photos), photos, confidences, groups)
        : named.isEmpty() ? plain : ShiftedFit.of(alone, named, photos, confidences, groups);
  }

  /**
   * Checks what is named before anything is fitted.
   *
   * @throws InputException when a covariate is not known of every photo
   */
  void requireKnown(List<Measurement> photos) {
    List<Covariate> known = ofScenarios(photos);
    named.stream()
        .filter(one -> !known.contains(one))
        .findFirst()
        .ifPresent(one -> refuse(one, known));
  }

  private static List<Covariate> ofScenarios(List<Measurement> photos) {
    return known(photos).stream().filter(one -> one.condition().isPresent()).toList();
  }

  private static void refuse(Covariate covariate, List<Covariate> known) {
    throw new InputException(
        "covariate '%s' is not known of every photo, or the same for all, expected %s"
            .formatted(covariate.column(), known.isEmpty() ? "none" : "some of " + columns(known)));
  }

  /** Takes the best one beside those that there are, as long as it helps. */
  private static ShiftedFit forward(
      ShiftedFit plain,
      List<Covariate> known,
      List<Measurement> photos,
      double[] confidences,
      Groups groups) {
    ShiftedFit now = plain;
    List<Covariate> taken = List.of();
    while (taken.size() < known.size()) {
      List<Covariate> before = taken;
      Optional<ShiftedFit> next =
          known.stream()
              .filter(one -> !before.contains(one))
              .map(one -> ShiftedFit.of(plain.g(), more(before, one), photos, confidences, groups))
              .min(Comparator.comparingDouble(one -> Arrays.stream(one.g().groupErrors()).sum()));
      if (!next.orElseThrow().helpsBeside(now)) {
        break;
      }
      now = next.get();
      taken = now.shifts().all().terms().stream().map(Shift.Term::covariate).toList();
    }
    return now;
  }

  private static List<Covariate> more(List<Covariate> taken, Covariate one) {
    List<Covariate> more = new ArrayList<>(taken);
    more.add(one);
    return more.stream().sorted().toList();
  }

  private static String columns(List<Covariate> covariates) {
    return covariates.stream().map(Covariate::column).collect(Collectors.joining(", "));
  }
}
