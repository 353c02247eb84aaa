package org.hificamsim.profiling.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Predicate;
import org.hificamsim.profiling.trial.Covered;
import org.hificamsim.profiling.trial.Trial;
import org.hificamsim.profiling.trial.TrialRun;
import org.hificamsim.profiling.trial.Trials;

/** What the simulator detects with the recommended models, beside what was measured. */
final class SimulationTables {
  static final String PHOTOS =
      "Each photo is set up again in the simulator: one camera with its lens, one target of its"
          + " size at its distance, and the model as it is fitted without that object. It detects"
          + " where the model's value reaches the threshold; the photo does where the measured"
          + " confidence does. Missed: the photo alone detects. Invented: the simulator alone does."
          + " Balanced accuracy is one half for a guess. Every photo is in simulation.csv.";

  static final String SCENES =
      "Targets before "
          + TrialRun.CAMERAS
          + " cameras each: an object is drawn, and photos of it, which say where the cameras stand"
          + " and through which lens they look. Then k, the number of cameras that detect it, is"
          + " what the simulator says, and what the confidences of these photos say. By chance"
          + " is --detect chance with its own threshold, as expected over its luck.";

  private static final int BANDS = 10;

  private final List<Trials> all;

  SimulationTables(List<Trials> all) {
    this.all = all;
  }

  void photos(HtmlPage page) {
    page.table(
        List.of(
            "model",
            "threshold",
            "photos detect",
            "simulator detects",
            "agree",
            "worst object",
            "missed",
            "invented",
            "balanced accuracy"),
        all.stream().map(SimulationTables::photos).toList());
  }

  private static List<String> photos(Trials one) {
    return List.of(
        one.model().name(),
        Cells.fixed(one.threshold(), 4),
        percent(one.share(Trial::measured)),
        percent(one.share(Trial::simulated)),
        percent(one.share(Trial::agrees)),
        percent(one.leastOfObject()),
        percent(one.share(Trial::missed)),
        percent(one.share(Trial::invented)),
        Cells.fixed(one.balanced(), 3));
  }

  void scenes(HtmlPage page) {
    List<List<String>> rows = new ArrayList<>();
    for (Trials one : all) {
      rows.add(row(one, "threshold", one.measured(), one.simulated()));
      one.byChance().ifPresent(by -> rows.add(row(one, "chance", one.measuredByChance(), by)));
    }
    page.table(
        List.of(
            "model",
            "by",
            "k of 1 or more: photos",
            "simulator",
            "k of 2 or more: photos",
            "simulator",
            "mean k: photos",
            "simulator"),
        rows);
  }

  private static List<String> row(Trials one, String rule, Covered photos, Covered simulator) {
    return List.of(
        one.model().name(),
        rule,
        percent(photos.once()),
        percent(simulator.once()),
        percent(photos.more()),
        percent(simulator.more()),
        Cells.fixed(photos.meanK(), 2),
        Cells.fixed(simulator.meanK(), 2));
  }

  /** Agreement by distance, of the photos in order of it. */
  void distances(HtmlPage page) {
    List<String> columns = new ArrayList<>(List.of("distance, m", "photos"));
    for (Trials one : all) {
      String detector = one.model().detector();
      columns.addAll(List.of(detector + " detects", "simulator", "agree", "missed", "invented"));
    }
    page.table(columns, bands().stream().map(this::distances).toList());
  }

  /** From which to which distance. */
  private record Band(double from, double to) {
    List<Trial> of(Trials trials) {
      return trials.photos().stream()
          .filter(one -> one.photo().distance() >= from && one.photo().distance() <= to)
          .toList();
    }
  }

  /** Each distance, or bands of several where there are many. */
  private List<Band> bands() {
    List<Double> distances =
        all.get(0).photos().stream()
            .map(one -> one.photo().distance())
            .distinct()
            .sorted(Comparator.naturalOrder())
            .toList();
    int bands = Math.min(BANDS, distances.size());
    List<Band> all = new ArrayList<>();
    for (int i = 0; i < bands; i++) {
      int first = i * distances.size() / bands;
      int last = (i + 1) * distances.size() / bands - 1;
      all.add(new Band(distances.get(first), distances.get(last)));
    }
    return all;
  }

  private List<String> distances(Band band) {
    String from = Cells.significant(band.from());
    List<String> row = new ArrayList<>();
    row.add(band.from() == band.to() ? from : from + " to " + Cells.significant(band.to()));
    row.add(String.valueOf(band.of(all.get(0)).size()));
    for (Trials one : all) {
      List<Trial> own = band.of(one);
      row.add(percent(share(own, Trial::measured)));
      row.add(percent(share(own, Trial::simulated)));
      row.add(percent(share(own, Trial::agrees)));
      row.add(percent(share(own, Trial::missed)));
      row.add(percent(share(own, Trial::invented)));
    }
    return row;
  }

  private static double share(List<Trial> trials, Predicate<Trial> what) {
    return (double) trials.stream().filter(what).count() / trials.size();
  }

  private static String percent(double share) {
    return Cells.fixed(100 * share, 0) + " %";
  }
}
