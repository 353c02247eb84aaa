package org.hificamsim.placement.output;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.data.CsvRow;
import org.hificamsim.placement.cover.CoverInstance;
import org.hificamsim.placement.cover.CoverPlan;
import org.hificamsim.placement.cover.CoverSearch;
import org.hificamsim.placement.cover.Duals;
import org.hificamsim.placement.cover.Effort;
import org.hificamsim.placement.cover.Goal;
import org.hificamsim.placement.site.CoverageReading;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.SampleSight;
import org.hificamsim.runs.output.ResultFolder;

/**
 * Checks a plan from its folder alone, by the sight of {@code run}: a target stands in each sample,
 * steps are simulated, and what cameras detect is counted; for the plan, and for every candidate,
 * from which the multipliers make the bound again.
 */
public final class PlanCheck {
  private static final double MARGIN = 1e-6;
  private static final int TOGETHER = 200; // candidates in one world

  private final Path file;
  private final JsonNode summary;
  private final List<CsvRow> rows;
  private final Demand demand;
  private final SampleSight sight;
  private final boolean any;
  private final Effort effort;

  private PlanCheck(
      Path folder,
      Scenario plan,
      Catalogue catalogue,
      Function<String, Detection> detections,
      Effort effort)
      throws IOException {
    this.effort = effort;
    file = folder.resolve(ResultFolder.SUMMARY);
    summary = new ResultFolder(folder).json(ResultFolder.SUMMARY);
    rows = PlanTables.SAMPLES.read(folder).rows();
    demand = demand(plan, detections);
    sight = new SampleSight(demand, catalogue);
    String reading = summary.path("reading").asText();
    any = Spelling.require(CoverageReading.class, "reading", reading) == CoverageReading.ANY;
  }

  /**
   * Checks a folder.
   *
   * @param reader reads a scenario
   * @param detections finds that of a zone by its name
   * @param effort may have an exact method, which proves what multipliers do not
   * @return what was found true, a line each
   * @throws InputException when something is not as the folder says
   */
  public static List<String> check(
      Path folder,
      Function<Path, Scenario> reader,
      Catalogue catalogue,
      Function<String, Detection> detections,
      Effort effort)
      throws IOException {
    Scenario plan = reader.apply(folder.resolve(PlanFiles.SCENARIO));
    List<CameraSpec> candidates = reader.apply(folder.resolve(PlanFiles.CANDIDATES)).cameras();
    return new PlanCheck(folder, plan, catalogue, detections, effort)
        .lines(plan.cameras(), candidates);
  }

  /** What the table of samples says. */
  private Demand demand(Scenario plan, Function<String, Detection> detections) {
    List<Demand.Watched> zones = new ArrayList<>();
    List<Demand.Sample> samples = new ArrayList<>();
    for (JsonNode zone : summary.path("zones")) {
      Detection named = detections.apply(zone.path("detection").asText());
      double threshold = zone.path("threshold").asDouble();
      Detection own = new Detection(named.name(), named.model(), threshold);
      int first = samples.size();
      int k = zone.path("k").asInt();
      while (samples.size() < rows.size()
          && rows.get(samples.size()).text("zone").equals(zone.path("name").asText())) {
        CsvRow row = rows.get(samples.size());
        double weight = row.number("weight", 0, 1e15, "a weight");
        samples.add(
            new Demand.Sample(row.numberOrNaN("x"), row.numberOrNaN("y"), zones.size(), weight));
      }
      zones.add(new Demand.Watched(zone.path("name").asText(), own, k, first, samples.size()));
    }
    if (samples.size() < rows.size()) {
      throw rows.get(samples.size()).invalid("zone", "the zones of " + file + ", in their order");
    }
    return new Demand(plan, null, zones, samples);
  }

  private List<String> lines(List<CameraSpec> cameras, List<CameraSpec> candidates) {
    int[] counts = count(seen(cameras));
    for (int s = 0; s < counts.length; s++) {
      if (rows.get(s).numberOrNaN("seen") != counts[s]) {
        throw rows.get(s).invalid("seen", counts[s] + ", the cameras that cover it in a run");
      }
    }
    CoverInstance all = all(candidates);
    double share = all.worth(counts) / all.total();
    requireSame("share", share);
    int kept = summary.path("kept").asInt();
    int[] standing = count(seen(cameras.subList(0, kept)));
    boolean cover = summary.path("goal").asText().equals("cover");
    Goal goal = cover ? Goal.ALL : new Goal(summary.path("budget").asDouble());
    double worth = all.worth(counts) - all.worth(standing);
    if (summary.has("unrefined")) {
      int[] chosen = chosen(cameras.subList(kept, cameras.size()), candidates);
      worth = all.after(standing).worth(all.counts(chosen));
      double before = (all.worth(standing) + worth) / all.total();
      requireSame("share_unrefined", before);
      requireNoBetter("share", share, before, "the share before refinement", goal);
    }
    double score = cover ? summary.path("price").asDouble() : worth;
    requireSame("score", score);
    double bound = summary.path("bound").asDouble();
    double relaxed = summary.path("bound_of_multipliers").asDouble(bound);
    CoverInstance after = all.after(standing);
    CoverInstance left = (cover ? after.coverable() : after).undominated();
    double[] multipliers =
        rows.stream().mapToDouble(row -> row.number("multiplier", 0, 1e15, "0 or more")).toArray();
    double proven = Duals.value(left, goal, multipliers);
    requireNoBetter("bound_of_multipliers", relaxed, proven, "which the multipliers prove", goal);
    requireNoBetter("bound", bound, score, "the score", goal);
    String by = "holds";
    if (Math.abs(bound - relaxed) > MARGIN * Math.max(1, Math.abs(bound))) {
      by =
          effort.exact().isPresent()
              ? proven(left, goal, bound)
              : "is checked by the method exact alone";
    }
    double shown = cover ? bound : 100 * Math.min(1, (all.worth(standing) + bound) / all.total());
    return List.of(
        Texts.format("%d cameras meet %.2f %% of the demand", cameras.size(), 100 * share),
        Texts.format(
            "the bound of %.2f%s %s for %d candidates",
            shown, cover ? "" : " %", by, candidates.size()));
  }

  /** A bound may be no better than this. */
  private void requireNoBetter(String name, double said, double least, String why, Goal goal) {
    double margin = MARGIN * Math.max(1, Math.abs(least));
    if (goal.isAll() ? said > least + margin : said < least - margin) {
      throw wrong(name, said, least + ", " + why);
    }
  }

  /** Solves anew, without the plan, what remains of the problem. */
  private String proven(CoverInstance left, Goal goal, double bound) {
    CoverPlan found = CoverSearch.solve(left, goal, effort, (score, its) -> {});
    requireNoBetter("bound", bound, found.score(), "of a plan that is better", goal);
    double margin = MARGIN * Math.max(1, Math.abs(bound));
    boolean holds =
        goal.isAll() ? found.bound() >= bound - margin : found.bound() <= bound + margin;
    return holds ? "holds" : "is not proven in this time";
  }

  private void requireSame(String name, double found) {
    double said = summary.path(name).asDouble(Double.NaN);
    if (!(Math.abs(said - found) <= MARGIN * Math.max(1, Math.abs(found)))) {
      throw wrong(name, said, found + ", as a run finds it");
    }
  }

  private InputException wrong(String name, double said, String expected) {
    return new InputException("%s: %s is %s, expected %s".formatted(file, name, said, expected));
  }

  /** The candidates whose cameras were moved: of the same lenses, each in its turn. */
  private int[] chosen(List<CameraSpec> moved, List<CameraSpec> candidates) {
    int[] chosen = new int[moved.size()];
    for (int i = 0; i < chosen.length; i++) {
      chosen[i] = summary.path("unrefined").path(i).asInt(-1);
      boolean known = chosen[i] >= 0 && chosen[i] < candidates.size();
      if (!known || !candidates.get(chosen[i]).optics().equals(moved.get(i).optics())) {
        throw wrong("unrefined", chosen[i], "a candidate with the lens of " + moved.get(i).name());
      }
    }
    return chosen;
  }

  /** All that is demanded, by candidate, as a run sees it. */
  private CoverInstance all(List<CameraSpec> candidates) {
    int[][] columns = new int[candidates.size()][];
    double[] prices = new double[columns.length];
    boolean byNumber = summary.path("goal").asText().equals("cameras");
    for (int from = 0; from < columns.length; from += TOGETHER) {
      int end = Math.min(columns.length, from + TOGETHER);
      System.arraycopy(seen(candidates.subList(from, end)), 0, columns, from, end - from);
    }
    for (int j = 0; j < prices.length; j++) {
      String kind = candidates.get(j).name().replaceFirst("/\\d+$", "");
      prices[j] = byNumber ? 1 : summary.path("prices").path(kind).asDouble();
    }
    return new CoverInstance(demand.units(), demand.needs(), columns, prices);
  }

  private int[] count(int[][] columns) {
    int[] counts = new int[rows.size()];
    Arrays.stream(columns).flatMapToInt(Arrays::stream).forEach(sample -> counts[sample]++);
    return counts;
  }

  /** What each camera detects in a run, by the reading: rising. */
  private int[][] seen(List<CameraSpec> cameras) {
    boolean[][] seen = new boolean[cameras.size()][rows.size()];
    SeenPairs pairs = new SeenPairs();
    for (Demand.Watched zone : cameras.isEmpty() ? List.<Demand.Watched>of() : demand.zones()) {
      Each policy = new Each(any);
      do {
        Simulation run =
            new Simulation(sight.world(zone, cameras), zone.detection(), policy, 0, List.of());
        run.step();
        pairs.clear();
        run.network().findSeen(pairs);
        for (int i = 0; i < pairs.count(); i++) {
          seen[pairs.camera(i)][zone.first() + pairs.target(i)] = true;
        }
      } while (policy.goOn());
    }
    return Arrays.stream(seen)
        .map(its -> IntStream.range(0, its.length).filter(sample -> its[sample]).toArray())
        .toArray(int[][]::new);
  }

  /**
   * Cameras stay as they start; or all look at their view of a number, one number after another.
   */
  private static final class Each implements ZoomPolicy {
    private final boolean all;
    private int view;
    private int most;

    Each(boolean all) {
      this.all = all;
    }

    boolean goOn() {
      return all && ++view < most;
    }

    @Override
    public String name() {
      return "each";
    }

    @Override
    public boolean jumps() {
      return true;
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      for (int camera = 0; camera < views.length && all; camera++) {
        most = Math.max(most, network.views(camera));
        views[camera] = Math.min(view, network.views(camera) - 1);
      }
    }
  }
}
