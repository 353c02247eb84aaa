package org.hificamsim.placement.output;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
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
import org.hificamsim.placement.site.CoverageReading;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.Demand.DemandPoint;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.placement.site.PlanArea;
import org.hificamsim.placement.site.PointSight;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.solver.cover.CoverInstance;
import org.hificamsim.solver.cover.CoverPlan;
import org.hificamsim.solver.cover.CoverSearch;
import org.hificamsim.solver.cover.Effort;
import org.hificamsim.solver.cover.Goal;
import org.hificamsim.solver.cover.LagrangianBound;

/**
 * Checks a plan by the files in its folder only. A target stands at each point of the demand, steps
 * are simulated as in {@code run}, and what cameras detect is counted. If the folder has all
 * candidates, these are simulated, too, and the multipliers then give the bound again.
 */
public final class PlanCheck {
  private static final double MARGIN = 1e-6;
  private static final int CANDIDATES_PER_WORLD = 200;

  private final Path file;
  private final JsonNode summary;
  private final List<CsvRow> rows;
  private final Demand demand;
  private final PointSight sight;
  private final CoverageReading reading;
  private final Effort effort;
  private final List<CameraSpec> cameras;

  /** All candidates of the plan; empty if it was written without them. */
  private final List<CameraSpec> candidates;

  /**
   * Reads a plan.
   *
   * @param reader reads a scenario
   * @param detections finds the detection that a zone names
   * @param effort how to prove a bound that multipliers do not prove: by its exact method, if it
   *     has one
   */
  public PlanCheck(
      Path folder,
      Function<Path, Scenario> reader,
      Catalogue catalogue,
      Function<String, Detection> detections,
      Effort effort)
      throws IOException {
    this.effort = effort;
    Scenario plan = reader.apply(folder.resolve(PlanFiles.SCENARIO));
    cameras = plan.cameras();
    Path all = folder.resolve(PlanFiles.CANDIDATES);
    candidates = Files.exists(all) ? reader.apply(all).cameras() : List.of();
    file = folder.resolve(ResultFolder.SUMMARY);
    summary = new ResultFolder(folder).json(ResultFolder.SUMMARY);
    rows = PlanTables.POINTS.read(folder).rows();
    demand = demand(plan, detections);
    sight = new PointSight(demand, catalogue);
    String name = summary.path("reading").asText();
    reading = Spelling.require(CoverageReading.class, "reading", name);
  }

  /** Reads the demand from the table of points. */
  private Demand demand(Scenario plan, Function<String, Detection> detections) {
    List<ZoneDemand> zones = new ArrayList<>();
    List<DemandPoint> points = new ArrayList<>();
    for (JsonNode zone : summary.path("zones")) {
      String zoneName = zone.path("name").asText();
      Detection named = detections.apply(zone.path("detection").asText());
      double threshold = zone.path("threshold").asDouble();
      Detection detection = new Detection(named.name(), named.model(), threshold);
      int first = points.size();
      while (points.size() < rows.size() && rows.get(points.size()).text("zone").equals(zoneName)) {
        CsvRow row = rows.get(points.size());
        double weight = row.number("weight", 0, 1e15, "a weight");
        points.add(
            new DemandPoint(row.numberOrNaN("x"), row.numberOrNaN("y"), zones.size(), weight));
      }
      int k = zone.path("k").asInt();
      zones.add(new ZoneDemand(zoneName, detection, k, first, points.size()));
    }
    if (points.size() < rows.size()) {
      throw rows.get(points.size()).invalid("zone", "the zones of " + file + ", in their order");
    }
    return new Demand(plan, List.of(), zones, points);
  }

  /** The number of cameras that are simulated: those of the plan and all candidates. */
  public int simulated() {
    return cameras.size() + candidates.size();
  }

  /**
   * Checks the plan.
   *
   * @param progress action to run after each camera that is simulated
   * @return what was confirmed, in lines for people
   * @throws InputException if anything is not as the folder says
   */
  public List<String> check(Runnable progress) {
    int[] counts = counts(seen(cameras));
    cameras.forEach(camera -> progress.run());
    requireCounts(counts);
    CoverInstance instance = instance(progress);
    double share = instance.worth(counts) / instance.totalWorth();
    requireSame("share", share);
    PlanArea area = PlanArea.of(demand, sight, cameras, reading);
    requireSame("share_of_area", area.share());
    List<String> lines = new ArrayList<>();
    lines.add(
        Texts.format(
            "%d cameras meet %.2f %% of the demand, and %.2f %% of its samples",
            cameras.size(), 100 * (demand.isForArea() ? area.share() : share), 100 * share));
    for (int number = 0; number < demand.zones().size(); number++) {
      String name = demand.zones().get(number).name();
      lines.add(
          Texts.format(
              "zone %s: %.2f %% of its area", name, 100 * area.zones().get(number).share()));
    }
    lines.add(
        candidates.isEmpty()
            ? "the bound is not checked, expected a plan that was written with all candidates"
            : bound(instance, counts));
    return lines;
  }

  /** Computes the bound again, and returns a sentence about it. */
  private String bound(CoverInstance instance, int[] counts) {
    int kept = summary.path("kept").asInt();
    int[] keptCounts = counts(seen(cameras.subList(0, kept)));
    double keptWorth = instance.worth(keptCounts);
    Goal goal = isFullCover() ? Goal.FULL_COVER : new Goal(summary.path("budget").asDouble());
    double worth = instance.worth(counts) - keptWorth;
    CoverInstance remaining = instance.remaining(keptCounts);
    if (summary.has("unrefined")) {
      int[] chosen = unrefined(cameras.subList(kept, cameras.size()));
      worth = remaining.worth(instance.counts(chosen));
      double before = (keptWorth + worth) / instance.totalWorth();
      requireSame("share_unrefined", before);
      double share = instance.worth(counts) / instance.totalWorth();
      requireNoBetter("share", share, before, "the share before refinement", goal);
    }
    double score = isFullCover() ? summary.path("price").asDouble() : worth;
    requireSame("score", score);
    CoverInstance undominated = (isFullCover() ? remaining.coverable() : remaining).undominated();
    double bound = summary.path("bound").asDouble();
    String verdict = checkBound(undominated, goal, score, bound);
    double shownBound =
        isFullCover() ? bound : 100 * Math.min(1, (keptWorth + bound) / instance.totalWorth());
    return Texts.format(
        "the bound of %.2f%s %s for %d candidates",
        shownBound, isFullCover() ? "" : " %", verdict, candidates.size());
  }

  private boolean isFullCover() {
    return summary.path("goal").asText().equals("cover");
  }

  private void requireCounts(int[] counts) {
    for (int number = 0; number < counts.length; number++) {
      if (rows.get(number).numberOrNaN("seen") != counts[number]) {
        throw rows.get(number)
            .invalid("seen", counts[number] + ", the cameras that cover it in a run");
      }
    }
  }

  /** Checks the bound, and returns a part of a sentence about it. */
  private String checkBound(CoverInstance undominated, Goal goal, double score, double bound) {
    double multiplierBound = summary.path("bound_of_multipliers").asDouble(bound);
    double[] multipliers =
        rows.stream().mapToDouble(row -> row.number("multiplier", 0, 1e15, "0 or more")).toArray();
    double proven = LagrangianBound.value(undominated, goal, multipliers);
    requireNoBetter(
        "bound_of_multipliers", multiplierBound, proven, "which the multipliers prove", goal);
    requireNoBetter("bound", bound, score, "the score", goal);
    if (Math.abs(bound - multiplierBound) <= MARGIN * Math.max(1, Math.abs(bound))) {
      return "holds";
    }
    return effort.exact().isPresent()
        ? proveExactly(undominated, goal, bound)
        : "is checked by the method exact alone";
  }

  /** Solves the problem again, without knowing the plan, and returns a part of a sentence. */
  private String proveExactly(CoverInstance undominated, Goal goal, double bound) {
    CoverPlan found =
        CoverSearch.solveUndominated(undominated, goal, effort, (newScore, newBound) -> {});
    requireNoBetter("bound", bound, found.score(), "of a plan that is better", goal);
    double margin = MARGIN * Math.max(1, Math.abs(bound));
    boolean holds =
        goal.isFullCover() ? found.bound() >= bound - margin : found.bound() <= bound + margin;
    return holds ? "holds" : "is not proven in this time";
  }

  /** Refuses a bound in the folder that is better than one that was found. */
  private void requireNoBetter(String name, double value, double limit, String reason, Goal goal) {
    double margin = MARGIN * Math.max(1, Math.abs(limit));
    if (goal.isFullCover() ? value > limit + margin : value < limit - margin) {
      throw wrong(name, value, limit + ", " + reason);
    }
  }

  private void requireSame(String name, double found) {
    double value = summary.path(name).asDouble(Double.NaN);
    if (!(Math.abs(value - found) <= MARGIN * Math.max(1, Math.abs(found)))) {
      throw wrong(name, value, found + ", as a run finds it");
    }
  }

  private InputException wrong(String name, double value, String expected) {
    return new InputException("%s: %s is %s, expected %s".formatted(file, name, value, expected));
  }

  /** Returns the candidates from which cameras were refined; lenses and order are the same. */
  private int[] unrefined(List<CameraSpec> refined) {
    int[] chosen = new int[refined.size()];
    for (int i = 0; i < chosen.length; i++) {
      chosen[i] = summary.path("unrefined").path(i).asInt(-1);
      boolean known = chosen[i] >= 0 && chosen[i] < candidates.size();
      if (!known || !candidates.get(chosen[i]).optics().equals(refined.get(i).optics())) {
        throw wrong(
            "unrefined", chosen[i], "a candidate with the lens of " + refined.get(i).name());
      }
    }
    return chosen;
  }

  /** Returns the covering problem of the whole demand, with what candidates detect in a run. */
  private CoverInstance instance(Runnable progress) {
    int[][] covered = new int[candidates.size()][];
    double[] prices = new double[covered.length];
    boolean byNumber = summary.path("goal").asText().equals("cameras");
    for (int from = 0; from < covered.length; from += CANDIDATES_PER_WORLD) {
      int end = Math.min(covered.length, from + CANDIDATES_PER_WORLD);
      System.arraycopy(seen(candidates.subList(from, end)), 0, covered, from, end - from);
      candidates.subList(from, end).forEach(candidate -> progress.run());
    }
    for (int candidate = 0; candidate < prices.length; candidate++) {
      String kind = candidates.get(candidate).name().replaceFirst("/\\d+$", "");
      prices[candidate] = byNumber ? 1 : summary.path("prices").path(kind).asDouble();
    }
    return new CoverInstance(demand.unitWorths(), demand.needs(), covered, prices);
  }

  private int[] counts(int[][] covered) {
    int[] counts = new int[rows.size()];
    Arrays.stream(covered).flatMapToInt(Arrays::stream).forEach(point -> counts[point]++);
    return counts;
  }

  /** Returns, by camera, the points that it detects in a run according to the reading, rising. */
  private int[][] seen(List<CameraSpec> cameras) {
    boolean[][] seen = new boolean[cameras.size()][rows.size()];
    SeenPairs pairs = new SeenPairs();
    for (ZoneDemand zone : cameras.isEmpty() ? List.<ZoneDemand>of() : demand.zones()) {
      LookingPolicy policy = new LookingPolicy(reading == CoverageReading.ANY);
      do {
        Simulation run =
            new Simulation(sight.world(zone, cameras), zone.detection(), policy, 0, List.of());
        run.step();
        pairs.clear();
        run.network().findSeen(pairs);
        for (int i = 0; i < pairs.count(); i++) {
          int point = zone.first() + pairs.target(i);
          seen[pairs.camera(i)][point] |=
              sight.showsFace(run.network(), pairs.camera(i), zone, point);
        }
      } while (policy.goToNextView());
    }
    return Arrays.stream(seen).map(PlanCheck::trueIndices).toArray(int[][]::new);
  }

  private static int[] trueIndices(boolean[] values) {
    return IntStream.range(0, values.length).filter(index -> values[index]).toArray();
  }

  /** Leaves cameras at their first views; or turns all cameras to one view number after another. */
  private static final class LookingPolicy implements ZoomPolicy {
    private final boolean turning;
    private int view;
    private int maxViews;

    LookingPolicy(boolean turning) {
      this.turning = turning;
    }

    /** Goes on to the next view number; returns whether any camera has such a view. */
    boolean goToNextView() {
      return turning && ++view < maxViews;
    }

    @Override
    public String name() {
      return "looking";
    }

    @Override
    public boolean jumps() {
      return true;
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      for (int camera = 0; camera < views.length && turning; camera++) {
        maxViews = Math.max(maxViews, network.views(camera));
        views[camera] = Math.min(view, network.views(camera) - 1);
      }
    }
  }
}
