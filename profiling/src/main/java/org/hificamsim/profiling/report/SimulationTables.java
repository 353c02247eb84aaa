package org.hificamsim.profiling.report;

import static org.hificamsim.profiling.report.CellText.fixed;
import static org.hificamsim.profiling.report.CellText.significant;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.hificamsim.profiling.dataset.TableLayout;
import org.hificamsim.profiling.trial.Trial;
import org.hificamsim.profiling.trial.Trials;
import org.hificamsim.profiling.trial.Trials.Covered;

/** What the simulator detects with the recommended models, compared with what was measured. */
final class SimulationTables {
  private static final int BANDS = 10;

  private final List<Trials> all;

  SimulationTables(List<Trials> all) {
    this.all = all;
  }

  void photos(HtmlPage page) {
    page.table(
        new TableLayout<Trials>()
            .with("model", one -> one.model().name())
            .with("threshold", one -> fixed(one.threshold(), 4))
            .with("photos detect", one -> share(one.photos(), Trial::measured))
            .with("simulator detects", one -> share(one.photos(), Trial::simulated))
            .with("agree", one -> share(one.photos(), Trial::agrees))
            .with("worst object", one -> percent(one.leastOfObject()))
            .with("missed", one -> share(one.photos(), Trial::missed))
            .with("invented", one -> share(one.photos(), Trial::invented))
            .with("balanced accuracy", one -> fixed(one.balanced(), 3)),
        all);
  }

  /** Coverage by photos and by the simulator, with one rule of detection. */
  private record SceneRow(String model, String rule, Covered photos, Covered simulator) {}

  void scenes(HtmlPage page) {
    List<SceneRow> rows = new ArrayList<>();
    for (Trials one : all) {
      String model = one.model().name();
      rows.add(new SceneRow(model, "threshold", one.measured(), one.simulated()));
      one.byChance()
          .ifPresent(by -> rows.add(new SceneRow(model, "chance", one.measuredByChance(), by)));
    }
    page.table(
        new TableLayout<SceneRow>()
            .with("model", SceneRow::model)
            .with("by", SceneRow::rule)
            .with("k of 1 or more: photos", row -> percent(row.photos.once()))
            .with("simulator", row -> percent(row.simulator.once()))
            .with("k of 2 or more: photos", row -> percent(row.photos.more()))
            .with("simulator", row -> percent(row.simulator.more()))
            .with("mean k: photos", row -> fixed(row.photos.meanK(), 2))
            .with("simulator", row -> fixed(row.simulator.meanK(), 2)),
        rows);
  }

  /** The photos of a band of distances. */
  private record BandRow(String model, double from, double to, List<Trial> photos) {
    static BandRow of(Trials trials, double from, double to) {
      return new BandRow(
          trials.model().name(),
          from,
          to,
          trials.photos().stream()
              .filter(one -> one.photo().distance() >= from && one.photo().distance() <= to)
              .toList());
    }

    String distance() {
      return from == to ? significant(from) : significant(from) + " to " + significant(to);
    }
  }

  /** Agreement by distance, or by bands of several where there are many; model after model. */
  void distances(HtmlPage page) {
    List<Double> distances =
        all.get(0).photos().stream()
            .map(one -> one.photo().distance())
            .distinct()
            .sorted()
            .toList();
    int bands = Math.min(BANDS, distances.size());
    List<BandRow> rows = new ArrayList<>();
    for (Trials one : all) {
      for (int band = 0; band < bands; band++) {
        int first = band * distances.size() / bands;
        int last = (band + 1) * distances.size() / bands - 1;
        rows.add(BandRow.of(one, distances.get(first), distances.get(last)));
      }
    }
    page.table(
        new TableLayout<BandRow>()
            .with("model", BandRow::model)
            .with("distance, m", BandRow::distance)
            .with("photos", row -> row.photos.size())
            .with("photos detect", row -> share(row.photos, Trial::measured))
            .with("simulator detects", row -> share(row.photos, Trial::simulated))
            .with("agree", row -> share(row.photos, Trial::agrees))
            .with("missed", row -> share(row.photos, Trial::missed))
            .with("invented", row -> share(row.photos, Trial::invented)),
        rows);
  }

  private static String share(List<Trial> trials, Predicate<Trial> what) {
    return percent(Trials.share(trials, what));
  }

  private static String percent(double share) {
    return fixed(100 * share, 0) + " %";
  }
}
