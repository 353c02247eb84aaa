package org.hificamsim.profiling.trial;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.profiling.dataset.TableLayout;
import org.hificamsim.profiling.fit.FittedModel;

/**
 * How the simulator does with one model against what was measured.
 *
 * @param threshold of the model, from which a confidence counts as detected
 * @param photos each photo alone
 * @param measured how the photos cover {@link TrialRun#SCENES} targets before {@link
 *     TrialRun#CAMERAS} cameras each, fewer where an object has fewer photos
 * @param simulated how the simulator does
 * @param measuredByChance how the photos cover them by the threshold of {@code --detect chance}
 * @param byChance what the simulator expects by that rule; empty where the model has no scatter
 */
public record Trials(
    FittedModel model,
    double threshold,
    List<Trial> photos,
    Covered measured,
    Covered simulated,
    Covered measuredByChance,
    Optional<Covered> byChance) {
  /** The name of the table of all photos. */
  public static final String FILE = "simulation.csv";

  /**
   * By how many cameras targets are covered, in the mean over many of them.
   *
   * @param once the share that one camera or more covers
   * @param more the share that two cameras or more cover
   * @param meanK the number of cameras that cover a target
   */
  public record Covered(double once, double more, double meanK) {
    /** One target. */
    static Covered by(long cameras) {
      return new Covered(cameras >= 1 ? 1 : 0, cameras >= 2 ? 1 : 0, cameras);
    }

    /** The mean over many. */
    static Covered mean(List<Covered> all) {
      return new Covered(
          mean(all, Covered::once), mean(all, Covered::more), mean(all, Covered::meanK));
    }

    private static double mean(List<Covered> all, ToDoubleFunction<Covered> part) {
      return all.stream().mapToDouble(part).average().orElseThrow();
    }
  }

  /** The share of the photos of which something holds. */
  public double share(Predicate<Trial> what) {
    return share(photos, what);
  }

  /** The share of some photos of which something holds. */
  public static double share(List<Trial> photos, Predicate<Trial> what) {
    return (double) photos.stream().filter(what).count() / photos.size();
  }

  /** The mean of the shares of the detected and of the undetected on which both agree. */
  public double balanced() {
    return (agreeing(Trial::measured) + agreeing(one -> !one.measured())) / 2;
  }

  private double agreeing(Predicate<Trial> kind) {
    return share(photos.stream().filter(kind).toList(), Trial::agrees);
  }

  /** The share of one object's photos on which both agree, where it is least. */
  public double leastOfObject() {
    return photos.stream()
        .map(one -> one.photo().object())
        .distinct()
        .mapToDouble(object -> agreeing(one -> one.photo().object().equals(object)))
        .min()
        .orElseThrow();
  }

  /** One sentence. */
  public String sentence() {
    return Texts.format(
        "In the simulation %s agrees with %.0f%% of %s (it misses %.0f%%, and invents"
            + " %.0f%%); it covers %.0f%% of %s before up to %s cameras, the photos cover"
            + " %.0f%%%s.",
        model.name(),
        100 * share(Trial::agrees),
        Texts.counted(photos.size(), "photo"),
        100 * share(Trial::missed),
        100 * share(Trial::invented),
        100 * simulated.once(),
        Texts.counted(TrialRun.SCENES, "target"),
        TrialRun.CAMERAS,
        100 * measured.once(),
        byChance
            .map(
                by ->
                    Texts.format(
                        "; by chance %.0f%% and %.0f%%",
                        100 * by.once(), 100 * measuredByChance.once()))
            .orElse(""));
  }

  /** A row of {@code simulation.csv}: a photo, as it was measured and as it is simulated. */
  private record Row(Trials of, Trial trial) {}

  private static final TableLayout<Row> COLUMNS =
      new TableLayout<Row>()
          .with("detector", row -> row.of.model.detector())
          .with("model", row -> row.of.model.name())
          .with("image", row -> TableLayout.quoted(row.trial.photo().image()))
          .with("object", row -> TableLayout.quoted(row.trial.photo().object()))
          .with("size_m", row -> row.trial.photo().size())
          .with("distance_m", row -> row.trial.photo().distance())
          .with("focal_length_m", row -> row.trial.photo().focalLength())
          .with("confidence", row -> row.trial.photo().confidence(row.of.model.detector()))
          .with("threshold", row -> row.of.threshold)
          .with("detected", row -> row.trial.measured() ? 1 : 0)
          .with("simulated", row -> row.trial.simulated() ? 1 : 0)
          .with("chance", row -> Double.isNaN(row.trial.chance()) ? "" : row.trial.chance());

  /** Writes every photo into a folder's {@code simulation.csv}. */
  public static void write(OutputFolder folder, List<Trials> all) throws IOException {
    folder.write(
        FILE,
        COLUMNS.csv(
            all.stream()
                .flatMap(one -> one.photos.stream().map(trial -> new Row(one, trial)))
                .toList()));
  }
}
