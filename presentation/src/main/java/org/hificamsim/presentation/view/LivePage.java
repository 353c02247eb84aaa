package org.hificamsim.presentation.view;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.policy.HindsightZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.hifi.density.DensityDetections;
import org.hificamsim.presentation.report.Page;
import org.hificamsim.runs.heat.HeatFigure;

/** The page that watches and commands a session. */
public final class LivePage {
  /** The standard whose levels are offered to zones. */
  private static final String STANDARD = "oodpcvs-2025";

  /**
   * The things that a user can draw.
   *
   * @param kinds the names of the cameras that can be mounted
   * @param plan whether the page begins with only a plan, without a simulation
   * @param scaled whether the plan has its scale already
   */
  public record DrawingTools(List<String> kinds, boolean plan, boolean scaled) {}

  private LivePage() {}

  /**
   * The page as HTML.
   *
   * @param scenario name
   * @param detection the detection that the session starts with; offered in addition to the
   *     catalogue's
   * @param tools what can be drawn
   */
  public static String html(
      Catalogue catalogue, String scenario, String detection, DrawingTools tools) {
    List<String> detections = new ArrayList<>(catalogue.detections().names());
    if (!detections.contains(detection)) {
      detections.add(0, detection);
    }
    List<Map<String, String>> policies =
        catalogue.policies().entries().stream()
            .filter(entry -> isLive(catalogue, entry.name()))
            .map(LivePage::describe)
            .toList();
    List<Map<String, String>> figures =
        Arrays.stream(HeatFigure.values())
            .map(figure -> Map.of("name", Spelling.of(figure), "label", figure.label()))
            .toList();
    Map<String, Object> data =
        Map.of(
            "scenario", scenario,
            "detections", detections,
            "policies", policies,
            "figures", figures,
            "levels", levels(),
            "tools", tools);
    try {
      String json = new ObjectMapper().writeValueAsString(data);
      return new Page(scenario + ", live", "view-page.js", "viewPage", json, "'self'").html();
    } catch (JsonProcessingException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The levels that a zone can ask for, with their names. */
  private static List<Map<String, String>> levels() {
    return DensityDetections.levels(STANDARD).stream()
        .map(level -> Map.of("name", level, "label", DensityDetections.levelName(level)))
        .toList();
  }

  /** Whether a policy can be viewed live: not if it looks at the whole run before it begins. */
  private static boolean isLive(Catalogue catalogue, String policy) {
    return !(catalogue.policies().create(policy) instanceof HindsightZoomPolicy);
  }

  private static Map<String, String> describe(Registry.Entry<?> entry) {
    return Map.of("name", entry.name(), "summary", entry.summary());
  }
}
