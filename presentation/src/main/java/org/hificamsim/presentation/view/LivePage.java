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
import org.hificamsim.presentation.report.Page;
import org.hificamsim.runs.heat.HeatFigure;

/** The page that watches and commands a session. */
public final class LivePage {
  private LivePage() {}

  /**
   * The page as HTML.
   *
   * @param scenario its name
   * @param detection of the start; offered in addition to the catalogue
   */
  public static String html(Catalogue catalogue, String scenario, String detection) {
    List<String> detections = new ArrayList<>(catalogue.detections().names());
    if (!detections.contains(detection)) {
      detections.add(0, detection);
    }
    List<Map<String, String>> policies =
        catalogue.policies().entries().stream()
            .filter(entry -> live(catalogue, entry.name()))
            .map(LivePage::described)
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
            "figures", figures);
    try {
      String json = new ObjectMapper().writeValueAsString(data);
      return new Page(scenario + ", live", "view-page.js", "viewPage", json, "'self'").html();
    } catch (JsonProcessingException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Whether a policy can be viewed live: none that looks at the whole run first. */
  private static boolean live(Catalogue catalogue, String policy) {
    return !(catalogue.policies().create(policy) instanceof HindsightZoomPolicy);
  }

  private static Map<String, String> described(Registry.Entry<?> entry) {
    return Map.of("name", entry.name(), "summary", entry.summary());
  }
}
