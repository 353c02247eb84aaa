package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.Drawing;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options of {@code view} that begin a site with a floor plan. */
final class NewSiteOptions {
  /** The width of a plan until its scale is set on the page, in metres. */
  private static final double DRAFT_WIDTH = 20;

  /** The height of the cameras, in metres. */
  private static final double MOUNT_HEIGHT = 3;

  @Option(names = "--new", paramLabel = "PLAN")
  private Optional<Path> plan;

  @Mixin private PlanOptions options;

  private boolean lacksScale;

  /** The floor plan; empty if a scenario is viewed. */
  Optional<Path> plan() {
    return plan;
  }

  /** Whether the page still has to set the scale of the site that was read. */
  boolean lacksScale() {
    return lacksScale;
  }

  /**
   * Returns the site of the plan, without cameras and people.
   *
   * @throws InputException if the plan cannot be read
   */
  Scenario site() {
    Path file = plan.orElseThrow();
    PlanReader reader = new PlanReader(file, options);
    lacksScale = options.frame().isEmpty() && (reader.isPicture() || reader.isSvg());
    if (lacksScale) {
      options.assumeWidth(DRAFT_WIDTH);
    }
    Optional<Drawing> drawing = reader.drawing(new LocalProjection());
    Optional<Path> picture = reader.isPicture() ? plan : options.floorplan();
    Optional<Floorplan> floorplan =
        picture.map(image -> new Floorplan(relativeToPlan(image), options.area(image)));
    String name = SiteOptions.safe(file.getFileName().toString().replaceFirst("\\.[^.]*$", ""));
    return reader
        .site(name, 0, OptionalDouble.empty(), drawing, floorplan)
        .scenario()
        .with(Scenario.MOUNT_HEIGHT, MOUNT_HEIGHT);
  }

  /** The path of a picture relative to the plan's folder, in which the scenario will be saved. */
  private String relativeToPlan(Path image) {
    Path folder = plan.orElseThrow().toAbsolutePath().getParent();
    return folder.relativize(image.toAbsolutePath()).toString();
  }

  /** Whether only the layers of the plan are asked for. */
  boolean listsLayers() {
    return plan.isPresent() && options.listsLayers();
  }

  /** Prints the layers of the plan. */
  void printLayers(PrintWriter terminal) {
    PlanReader reader = new PlanReader(plan.orElseThrow(), options);
    reader.printLayers(reader.drawing(new LocalProjection()), terminal);
  }
}
