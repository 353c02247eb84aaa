package org.hificamsim.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.hificamsim.tracks.SiteSettings;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.Drawing;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options of {@code view} that begin a site with a floor plan. */
final class NewSiteOptions {
  /** The width of a plan until its scale is set on the page, metres. */
  private static final double DRAFT_WIDTH = 20;

  /** The height of the cameras, metres. */
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
    if (options.listsLayers() || options.floorplan().isPresent()) {
      throw new InputException("--list-layers and --floorplan are for 'site', expected neither");
    }
    PlanReader reader = new PlanReader(file, options);
    lacksScale = options.frame().isEmpty() && (reader.isPicture() || reader.isSvg());
    if (lacksScale) {
      options.assumeWidth(DRAFT_WIDTH);
    }
    Optional<Drawing> drawing = reader.drawing(new LocalProjection());
    String fileName = file.getFileName().toString();
    Optional<Floorplan> picture =
        reader.isPicture()
            ? Optional.of(new Floorplan(fileName, options.area(file)))
            : Optional.empty();
    SiteSettings settings =
        new SiteSettings(
            SiteOptions.safe(fileName.replaceFirst("\\.[^.]*$", "")),
            file,
            0,
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            List.of(),
            Optional.empty());
    return reader
        .site(settings, drawing, picture)
        .scenario()
        .with(Scenario.MOUNT_HEIGHT, MOUNT_HEIGHT);
  }
}
