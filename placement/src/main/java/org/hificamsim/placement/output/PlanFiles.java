package org.hificamsim.placement.output;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.placement.output.PlanTables.Covered;
import org.hificamsim.placement.output.PlanTables.Planned;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.SitePlan;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.output.JsonOutput;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.ResultFolder;

/** Writes a plan: the scenario that runs, and all that is to be said of it. */
public final class PlanFiles {
  /** The scenario of the plan. */
  public static final String SCENARIO = "plan.xml";

  /** The site under all candidates at once, from which the bound can be made again. */
  public static final String CANDIDATES = "candidates.xml";

  private PlanFiles() {}

  /**
   * Adds the files to a folder's.
   *
   * @param floor of the site
   * @param command that made the plan
   */
  public static void write(
      OutputFolder folder,
      SitePlan plan,
      Catalogue catalogue,
      List<Setup.Floor> floor,
      List<String> command)
      throws IOException {
    new PlanSheet(plan, catalogue, floor)
        .write(folder, "./hificamsim " + String.join(" ", command), ManifestFile.version());
    folder.write(SCENARIO, ScenarioWriter.write(plan.scenario()));
    JsonOutput.write(folder, ResultFolder.SUMMARY, summary(plan));
    int[] counts = plan.counts();
    Demand demand = plan.demand();
    PlanTables.CAMERAS.write(
        folder, IntStream.range(0, plan.cameras().size()).mapToObj(i -> planned(plan, i)));
    folder.write(CANDIDATES, ScenarioWriter.write(plan.candidates()));
    PlanTables.SAMPLES.write(
        folder,
        IntStream.range(0, counts.length)
            .mapToObj(
                s -> {
                  Demand.Sample sample = demand.samples().get(s);
                  Demand.Watched zone = demand.zones().get(sample.zone());
                  return new Covered(zone, sample, counts[s], plan.plan().proof()[s]);
                }));
    PlanTables.CURVE.write(folder, plan.curve().stream());
  }

  static Planned planned(SitePlan plan, int camera) {
    return new Planned(
        plan.cameras().get(camera),
        plan.prices().get(camera),
        plan.covered()[camera].length,
        plan.share(plan.countsWithout(camera)));
  }

  private static ObjectNode summary(SitePlan plan) {
    int[] counts = plan.counts();
    Demand demand = plan.demand();
    boolean all = plan.problem().goal().isAll();
    ObjectNode json = new ObjectMapper().createObjectNode();
    json.put("scenario", demand.site().name());
    json.put("reading", Spelling.of(plan.problem().reading()));
    json.put("goal", all ? "cover" : plan.problem().byNumber() ? "cameras" : "budget");
    if (!all) {
      json.put("budget", plan.problem().goal().budget());
    }
    json.put("kept", plan.problem().kept().size());
    json.put("cameras", plan.cameras().size());
    json.put("price", plan.price());
    ObjectNode prices = json.putObject("prices");
    plan.problem()
        .candidates()
        .all()
        .forEach(one -> prices.put(one.kind().name(), one.kind().price()));
    json.put("samples", counts.length);
    json.put("cell", demand.cells().width());
    json.put("candidates", plan.problem().candidates().all().size());
    json.put("share", plan.share());
    if (plan.unrefined().isPresent()) {
      json.put("share_unrefined", plan.unrefined().get());
      json.put("gain_of_refinement", plan.share() - plan.unrefined().get());
      Arrays.stream(plan.plan().chosen()).forEach(json.putArray("unrefined")::add);
    }
    json.put("share_bound", plan.bound());
    json.put("score", plan.plan().score());
    json.put("bound", plan.plan().bound());
    json.put("bound_of_multipliers", plan.plan().relaxed());
    json.put("gap", plan.plan().gap());
    json.put("proven", plan.plan().isProven());
    json.put("share_of_site", plan.today());
    ArrayNode zones = json.putArray("zones");
    for (Demand.Watched zone : demand.zones()) {
      ObjectNode one = zones.addObject().put("name", zone.name());
      one.put("detection", zone.detection().name());
      one.put("threshold", zone.detection().threshold()).put("k", zone.k());
      one.put("share", demand.share(zone, counts, false));
      one.put("share_whole", demand.share(zone, counts, true));
    }
    plan.blindSpots().forEach(json.putArray("blind_spots")::addPOJO);
    return json;
  }
}
