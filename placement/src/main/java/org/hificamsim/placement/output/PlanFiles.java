package org.hificamsim.placement.output;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.Writer;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.hificamsim.placement.output.PlanTables.CameraRow;
import org.hificamsim.placement.output.PlanTables.PointRow;
import org.hificamsim.placement.site.CameraPlan;
import org.hificamsim.placement.site.Candidates.Candidate;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.Demand.DemandPoint;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.placement.site.PlacementProblem;
import org.hificamsim.placement.site.PlanCover;
import org.hificamsim.placement.site.SitePlan;
import org.hificamsim.placement.site.SitePlan.CurvePoint;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.output.JsonOutput;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.solver.cover.CoverPlan;

/**
 * Writes the files of a plan: a scenario that can be run, a summary, tables, pages and pictures.
 */
public final class PlanFiles {
  /** The scenario of the plan. */
  public static final String SCENARIO = "plan.xml";

  /** The plan for CAD programs. */
  private static final String DXF = "plan.dxf";

  /** The site with all candidates at once, from which the bound can be computed again. */
  public static final String CANDIDATES = "candidates.xml";

  private PlanFiles() {}

  /**
   * The content of documents in addition to the plan.
   *
   * @param site the file of the site; its floor plan is in the same folder
   * @param floor the floor plan of the site
   * @param command the words of the command that made the plan
   * @param progress receives the next part of the work, such as "draws the plan"
   */
  public record Content(
      Path site,
      List<Setup.Floor> floor,
      TitleBlock title,
      List<String> command,
      Consumer<String> progress) {}

  /** Returns the reason why a picture is missing; empty if all are drawn. */
  public static Optional<String> omission(CameraPlan plan) {
    return PlanSheet.omission(plan);
  }

  /** Adds the files of a plan to a folder, among them those that say how the search found it. */
  public static void write(OutputFolder folder, SitePlan plan, Catalogue catalogue, Content content)
      throws IOException {
    content.progress.accept("bounds the curve of coverage");
    List<CurvePoint> curve = plan.curve();
    writeDocuments(folder, plan, curve, catalogue, content);
    JsonOutput.write(folder, ResultFolder.SUMMARY, summary(plan));
    int[] counts = plan.cover().counts();
    Demand demand = plan.demand();
    double[] multipliers = plan.coverPlan().multiplierBound().multipliers();
    PlanTables.POINTS.write(
        folder,
        IntStream.range(0, counts.length)
            .mapToObj(
                number -> {
                  DemandPoint point = demand.points().get(number);
                  ZoneDemand zone = demand.zones().get(point.zone());
                  return new PointRow(zone, point, counts[number], multipliers[number]);
                }));
    PlanTables.CURVE.write(folder, curve.stream());
  }

  /**
   * Adds the documents about a plan, and its scenario, to a folder.
   *
   * @param curve the curve of coverage; empty if no plan was searched for
   */
  public static void writeDocuments(
      OutputFolder folder,
      CameraPlan plan,
      List<CurvePoint> curve,
      Catalogue catalogue,
      Content content)
      throws IOException {
    content.progress.accept("draws the plan");
    String command = ResultFolder.command(content.command);
    CameraSectors sectors = new CameraSectors(plan, catalogue);
    PlanSheet.Content sheet = new PlanSheet.Content(content.floor, content.title, command);
    new PlanSheet(plan, catalogue, sectors, curve, sheet).write(folder);
    content.progress.accept("writes its tables");
    PlanTables.ORDER.write(folder, PlanOrder.of(plan, content.title.currency()).stream());
    try (Writer dxf = folder.open(DXF)) {
      PlanDxf.write(dxf, plan, sectors);
    }
    folder.write(SCENARIO, ScenarioWriter.write(plan.scenario()));
    copyFloorplan(folder, plan, content.site);
    double[] sharesWithout = plan.cover().sharesWithout();
    PlanTables.CAMERAS.write(
        folder,
        IntStream.range(0, plan.cameras().size())
            .mapToObj(i -> cameraRow(plan, i, sharesWithout[i])));
  }

  /**
   * Copies the floor plan of the site into the folder, where the scenario of the plan expects it.
   */
  private static void copyFloorplan(OutputFolder folder, CameraPlan plan, Path site)
      throws IOException {
    Optional<Floorplan> original = plan.demand().site().floorplan();
    if (original.isPresent()) {
      String name = plan.scenario().floorplan().orElseThrow().file();
      folder.copy(name, site.resolveSibling(original.get().file()));
    }
  }

  /** Adds the file {@link #CANDIDATES}, which is large, to a folder. */
  public static void writeCandidates(OutputFolder folder, SitePlan plan) throws IOException {
    folder.write(CANDIDATES, ScenarioWriter.write(plan.candidateScenario()));
  }

  private static CameraRow cameraRow(CameraPlan plan, int number, double shareWithout) {
    CameraSpec camera = plan.cameras().get(number);
    int coveredPoints = plan.cover().covered()[number].length;
    return new CameraRow(camera, plan.height(camera), coveredPoints, shareWithout);
  }

  private static ObjectNode summary(SitePlan plan) {
    PlanCover cover = plan.cover();
    int[] counts = cover.counts();
    Demand demand = plan.demand();
    PlacementProblem problem = plan.problem();
    CoverPlan coverPlan = plan.coverPlan();
    boolean fullCover = problem.goal().isFullCover();
    ObjectNode json = new ObjectMapper().createObjectNode();
    json.put("scenario", demand.site().name());
    json.put("reading", Spelling.of(problem.request().reading()));
    json.put(
        "goal", fullCover ? "cover" : problem.request().goal().byNumber() ? "cameras" : "budget");
    if (!fullCover) {
      json.put("budget", problem.goal().budget());
    }
    json.put("kept", problem.kept().size());
    json.put("cameras", plan.cameras().size());
    json.put("price", plan.price());
    ObjectNode prices = json.putObject("prices");
    for (Candidate candidate : problem.candidates().list()) {
      prices.put(candidate.kind().name(), candidate.kind().price());
    }
    json.put("samples", counts.length);
    json.put("cell", demand.finestCells().width());
    json.put("largest_cell", demand.greatestCellWidth());
    json.put("candidates", problem.candidates().list().size());
    json.put("share", cover.share());
    json.put("share_of_area", cover.area().share());
    if (plan.shares().unrefined().isPresent()) {
      double unrefined = plan.shares().unrefined().get();
      json.put("share_unrefined", unrefined);
      json.put("gain_of_refinement", cover.share() - unrefined);
      Arrays.stream(coverPlan.chosen()).forEach(json.putArray("unrefined")::add);
    }
    json.put("share_bound", plan.shares().bound());
    json.put("score", coverPlan.score());
    json.put("bound", coverPlan.bound());
    json.put("bound_of_multipliers", coverPlan.multiplierBound().value());
    json.put("gap", coverPlan.gap());
    json.put("proven", coverPlan.isProven());
    plan.provenOf().ifPresent(these -> json.put("proven_of", these));
    json.put("share_of_site", plan.shares().ofSite());
    ArrayNode zones = json.putArray("zones");
    for (int number = 0; number < demand.zones().size(); number++) {
      ZoneDemand zone = demand.zones().get(number);
      ObjectNode zoneJson = zones.addObject().put("name", zone.name());
      zoneJson.put("detection", zone.detection().name());
      zoneJson.put("threshold", zone.detection().threshold()).put("k", zone.k());
      zoneJson.put("share", demand.share(zone, counts));
      zoneJson.put("share_whole", demand.shareByK(zone, counts));
      zoneJson.put("share_of_area", cover.area().zones().get(number).share());
    }
    cover.blindSpots().forEach(json.putArray("blind_spots")::addPOJO);
    return json;
  }
}
