package org.hificamsim.profiling.trial;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import org.hificamsim.profiling.fit.Counted;
import org.hificamsim.profiling.fit.FittedModel;

/**
 * How the simulator does with one model against what was measured.
 *
 * @param threshold of the model, from which a confidence counts as detected
 * @param photos each photo alone
 * @param scenes targets before {@link TrialRun#CAMERAS} cameras each
 * @param measured how the photos cover them
 * @param simulated how the simulator does
 * @param error the mean difference in the number of cameras that cover a target, without its sign
 * @param measuredByChance how the photos cover them by the threshold of {@code --detect chance}
 * @param byChance what the simulator expects by that rule; empty where the model has no scatter
 */
public record Trials(
    FittedModel model,
    double threshold,
    List<Trial> photos,
    int scenes,
    Covered measured,
    Covered simulated,
    double error,
    Covered measuredByChance,
    Optional<Covered> byChance) {
  /** The share of the photos of which something holds. */
  public double share(Predicate<Trial> what) {
    return (double) photos.stream().filter(what).count() / photos.size();
  }

  /** The mean of the shares of the detected and of the undetected on which both agree. */
  public double balanced() {
    return (within(Trial::measured) + within(one -> !one.measured())) / 2;
  }

  private double within(Predicate<Trial> kind) {
    long all = photos.stream().filter(kind).count();
    return (double) photos.stream().filter(kind).filter(Trial::agrees).count() / all;
  }

  /** The object on which they agree least. */
  public double leastOfObject() {
    return photos.stream()
        .map(one -> one.photo().object())
        .distinct()
        .mapToDouble(this::ofObject)
        .min()
        .orElseThrow();
  }

  private double ofObject(String object) {
    List<Trial> own = photos.stream().filter(one -> one.photo().object().equals(object)).toList();
    return (double) own.stream().filter(Trial::agrees).count() / own.size();
  }

  /** One sentence. */
  public String sentence() {
    return String.format(
        Locale.ROOT,
        "In the simulation %s agrees with %.0f%% of %s (it misses %.0f%%, and invents %.0f%%); it"
            + " covers %.0f%% of %s before %s cameras, the photos cover %.0f%%%s.",
        model.name(),
        100 * share(Trial::agrees),
        Counted.of(photos.size(), "photo"),
        100 * share(Trial::missed),
        100 * share(Trial::invented),
        100 * simulated.once(),
        Counted.of(scenes, "target"),
        TrialRun.CAMERAS,
        100 * measured.once(),
        byChance
            .map(
                by ->
                    String.format(
                        Locale.ROOT,
                        "; by chance %.0f%% and %.0f%%",
                        100 * by.once(),
                        100 * measuredByChance.once()))
            .orElse(""));
  }
}
