package org.hificamsim.placement.output;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.file.CsvTable;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Occlusion;
import org.hificamsim.core.scenario.OpticsLaw;
import org.hificamsim.core.scenario.OpticsSpec;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.core.world.World;
import org.hificamsim.data.CsvRow;
import org.hificamsim.placement.cover.CoverInstance;
import org.hificamsim.placement.cover.Duals;
import org.hificamsim.placement.cover.Goal;
import org.hificamsim.placement.site.CoverageReading;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.runs.output.ResultFolder;

/**
 * Checks a plan from its folder alone, by the sight of {@code run}: a target stands in each sample,
 * steps are simulated, and what cameras detect is counted; for the plan, and for every candidate,
 * from which the multipliers make the bound again.
 */
public final class PlanCheck {
  private static final double MARGIN = 1e-6;
  private static final int TOGETHER = 200; // candidates in one world

  private final Path folder;
  private final JsonNode summary;
  private final Scenario plan;
  private final Catalogue catalogue;
  private final Function<String, Detection> detections; // by name
  private final List<CsvRow> samples;
  private final Map<String, List<Integer>> byZone = new LinkedHashMap<>();
  private final CoverageReading reading;
  private final double[] units;
  private final int[] needs;

  private PlanCheck(
      Path folder, Scenario plan, Catalogue catalogue, Function<String, Detection> detections)
      throws IOException {
    this.folder = folder;
    this.plan = plan;
    this.catalogue = catalogue;
    this.detections = detections;
    this.summary = new ResultFolder(folder).json(ResultFolder.SUMMARY);
    this.samples = PlanTables.SAMPLES.read(folder).rows();
    this.reading =
        Spelling.require(CoverageReading.class, "reading", summary.path("reading").asText());
    this.units = new double[samples.size()];
    this.needs = new int[samples.size()];
    for (int s = 0; s < units.length; s++) {
      CsvRow row = samples.get(s);
      byZone.computeIfAbsent(row.text("zone"), any -> new ArrayList<>()).add(s);
      needs[s] = (int) row.number("needs", 1, 100, "a number of cameras");
      units[s] = row.number("weight", 0, 1e12, "a weight") / needs[s];
    }
  }

  /**
   * Checks a folder.
   *
   * @param detections finds that of a zone by its name
   * @return what was found true, a line each
   * @throws InputException when something is not as the folder says
   */
  public static List<String> check(
      Path folder, Scenario plan, Catalogue catalogue, Function<String, Detection> detections)
      throws IOException {
    return new PlanCheck(folder, plan, catalogue, detections).lines();
  }

  private List<String> lines() {
    List<String> lines = new ArrayList<>();
    int[] counts = count(seen(plan.cameras()));
    for (int s = 0; s < counts.length; s++) {
      CsvRow row = samples.get(s);
      if (row.numberOrNaN("seen") != counts[s]) {
        throw row.invalid("seen", counts[s] + ", the cameras that cover it in a run");
      }
    }
    CoverInstance all = new CoverInstance(units, needs, new int[0][], new double[0]);
    double share = all.worth(counts) / all.total();
    require("share", share);
    lines.add(
        plan.cameras().size() + " cameras meet " + share + " of the demand");
    lines.add(bound(all, counts));
    return lines;
  }

  private void require(String name, double found) {
    double said = summary.path(name).asDouble(Double.NaN);
    if (!(Math.abs(said - found) <= MARGIN * Math.max(1, Math.abs(found)))) {
      throw new InputException(
          "%s: %s is %s, expected %s, as a run finds it"
              .formatted(folder.resolve(ResultFolder.SUMMARY), name, said, found));
    }
  }

  /** What the multipliers prove with the candidates as a run sees them. */
  private String bound(CoverInstance all, int[] counts) {
    List<CameraSpec> candidates = new ArrayList<>();
    List<Double> prices = new ArrayList<>();
    boolean byNumber = summary.path("goal").asText().equals("cameras");
    for (CsvRow row : PlanTables.CANDIDATES.read(folder).rows()) {
      candidates.add(camera(row, candidates.size()));
      prices.add(byNumber ? 1 : row.numberOrNaN("price"));
    }
    int[][] columns = new int[candidates.size()][];
    for (int from = 0; from < columns.length; from += TOGETHER) {
      int end = Math.min(columns.length, from + TOGETHER);
      int[][] part = seen(candidates.subList(from, end));
      System.arraycopy(part, 0, columns, from, part.length);
    }
    int kept = summary.path("kept").asInt();
    int[] standing = count(seen(plan.cameras().subList(0, kept)));
    double[] asked = prices.stream().mapToDouble(Double::doubleValue).toArray();
    boolean cover = summary.path("goal").asText().equals("cover");
    Goal goal = cover ? Goal.ALL : new Goal(summary.path("budget").asDouble());
    CoverInstance left = new CoverInstance(units, needs, columns, asked).after(standing);
    left = cover ? left.coverable() : left;
    double proven = Duals.value(left.undominated(), goal, multipliers());
    double score = summary.path("score").asDouble();
    double bound = summary.path("bound").asDouble();
    double margin = MARGIN * Math.max(1, Math.abs(score));
    double reached = cover ? summary.path("price").asDouble() : worth(all, counts, standing);
    if (!(Math.abs(reached - score) <= margin)
        || (cover ? bound > score + margin : bound < score - margin)) {
      throw new InputException(
          "%s: score %s and bound %s, expected %s, and no bound that it passes"
              .formatted(folder.resolve(ResultFolder.SUMMARY), score, bound, reached));
    }
    boolean holds = cover ? bound <= proven + margin : bound >= proven - margin;
    String exact = "the bound %s is exact search's word; multipliers prove %s";
    String whole = "the bound %s holds: multipliers prove %s of %s candidates";
    return (holds ? whole : exact).formatted(bound, proven, candidates.size());
  }

  private static double worth(CoverInstance all, int[] counts, int[] standing) {
    return all.worth(counts) - all.worth(standing);
  }

  /** In the range in which any multipliers prove a bound. */
  private double[] multipliers() {
    double[] multipliers = new double[samples.size()];
    Arrays.setAll(multipliers, s -> samples.get(s).number("multiplier", 0, 1e12, "0 or more"));
    return multipliers;
  }

  private static CameraSpec camera(CsvRow row, int number) {
    List<Double> angles = numbers(row, "hfov");
    OpticsSpec optics =
        new OpticsSpec(row.text("kind") + number)
            .with(OpticsSpec.LAW, OpticsLaw.valueOf(row.text("law")))
            .with(OpticsSpec.ANGLES_OF_VIEW, angles)
            .with(OpticsSpec.PANS, numbers(row, "pan"));
    double pixels = row.numberOrNaN("pixels");
    double reach = row.numberOrNaN("reach");
    optics = reach > 0 ? optics.with(OpticsSpec.REACH, reach) : optics;
    return new CameraSpec("C" + number, row.numberOrNaN("x"), row.numberOrNaN("y"), 0)
        .with(CameraSpec.HEADING, row.numberOrNaN("heading"))
        .with(CameraSpec.VIEWING_ANGLE, angles.get(angles.size() - 1))
        .with(
            CameraSpec.OPTICS, pixels > 0 ? optics.with(OpticsSpec.PIXELS, (int) pixels) : optics);
  }

  private static List<Double> numbers(CsvRow row, String column) {
    try {
      return Arrays.stream(CsvTable.original(row.text(column)).split(" "))
          .map(Double::valueOf)
          .toList();
    } catch (NumberFormatException e) {
      throw row.invalid(column, "degrees between spaces");
    }
  }

  private int[] count(int[][] columns) {
    int[] counts = new int[samples.size()];
    Arrays.stream(columns).flatMapToInt(Arrays::stream).forEach(sample -> counts[sample]++);
    return counts;
  }

  /** What each camera detects in a run, by the reading: rising. */
  private int[][] seen(List<CameraSpec> cameras) {
    boolean[][] seen = new boolean[cameras.size()][samples.size()];
    if (!cameras.isEmpty()) {
      byZone.forEach((zone, its) -> look(cameras, detection(zone), its, seen));
    }
    int[][] columns = new int[seen.length][];
    for (int camera = 0; camera < seen.length; camera++) {
      boolean[] its = seen[camera];
      columns[camera] = IntStream.range(0, its.length).filter(sample -> its[sample]).toArray();
    }
    return columns;
  }

  private Detection detection(String zone) {
    for (JsonNode one : summary.path("zones")) {
      if (one.path("name").asText().equals(zone)) {
        Detection named = detections.apply(one.path("detection").asText());
        return new Detection(named.name(), named.model(), one.path("threshold").asDouble());
      }
    }
    throw new InputException(
        "%s: no zone '%s', expected those of %s"
            .formatted(folder.resolve(ResultFolder.SUMMARY), zone, PlanTables.SAMPLES.file()));
  }

  private void look(
      List<CameraSpec> cameras, Detection detection, List<Integer> its, boolean[][] seen) {
    List<TargetSpec> all = plan.everyTarget().toList();
    TargetSpec usual = Demand.usualTarget(all);
    List<TargetSpec> targets = new ArrayList<>();
    for (int sample : its) {
      CsvRow row = samples.get(sample);
      TargetSpec one = new TargetSpec(targets.size(), row.numberOrNaN("x"), row.numberOrNaN("y"));
      targets.add(usual.extent().map(one::withExtent).orElse(one.withSize(usual.size())));
    }
    Scenario still =
        plan.with(Scenario.CAMERAS, cameras)
            .with(Scenario.TARGETS, targets)
            .with(Scenario.EVENTS, List.of())
            .with(Scenario.OCCLUSION, Occlusion.NONE);
    Each policy = new Each(reading == CoverageReading.ANY);
    SeenPairs pairs = new SeenPairs();
    do {
      World world = new World(still, catalogue.movements(), 0);
      Simulation simulation = new Simulation(world, detection, policy, 0, List.of());
      simulation.step();
      pairs.clear();
      simulation.network().findSeen(pairs);
      for (int i = 0; i < pairs.count(); i++) {
        seen[pairs.camera(i)][its.get(pairs.target(i))] = true;
      }
    } while (policy.goOn());
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
