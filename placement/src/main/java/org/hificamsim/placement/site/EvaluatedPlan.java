package org.hificamsim.placement.site;

import java.util.List;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.Scenario;

/** The present cameras of a scenario, as a plan to evaluate. */
public record EvaluatedPlan(PlanCover cover, CoverageReading reading) implements CameraPlan {
  @Override
  public int keptCameras() {
    return 0;
  }

  @Override
  public List<Product> products() {
    return cameras().stream()
        .map(
            camera ->
                new Product(
                    camera.optics().map(Candidates::productOf).orElse(camera.name()),
                    camera.price()))
        .toList();
  }

  @Override
  public List<String> facts() {
    return List.of(
        claim("", priceText()),
        reading.words(),
        "the cameras are measured as they are; no better ones were looked for");
  }

  /** Returns the price of all cameras, and the number of those whose price is not known. */
  public String priceText() {
    long unknown = cameras().stream().filter(camera -> camera.price() == 0).count();
    String known = Texts.format("%.2f", price());
    return unknown == 0
        ? known
        : known + " (" + Texts.counted(unknown, "camera") + " without a price)";
  }

  @Override
  public Scenario scenario() {
    return CameraPlan.withFloorplanInFolder(demand().site());
  }
}
