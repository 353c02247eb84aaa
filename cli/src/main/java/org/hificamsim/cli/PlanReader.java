package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.hificamsim.tracks.DrawnSite;
import org.hificamsim.tracks.SiteSettings;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.Drawing;
import org.hificamsim.tracks.place.WallFile;

/**
 * Makes a site from a floor plan: a drawing, a map or a picture.
 *
 * @param file the plan
 * @param options the options for reading it
 */
record PlanReader(Path file, PlanOptions options) {
  /** Whether the plan is a picture, without walls. */
  boolean isPicture() {
    return hasEnding("png|jpe?g");
  }

  /** Whether the plan is a drawing whose unit may be on paper. */
  boolean isSvg() {
    return hasEnding("svgz?");
  }

  private boolean hasEnding(String endings) {
    return file.toString().toLowerCase(Locale.ROOT).matches(".*\\.(" + endings + ")");
  }

  /** Reads the walls; empty for a picture. */
  Optional<Drawing> drawing(LocalProjection projection) {
    Unit usual = WallFile.isGeoJson(file) ? Unit.DEG : Unit.M;
    return isPicture() ? Optional.empty() : Optional.of(options.read(file, usual, projection));
  }

  /**
   * Prints the layers of the plan with the numbers of their shapes.
   *
   * @param drawing the drawing that was read; empty for a picture
   * @throws InputException if the plan is a picture
   */
  void printLayers(Optional<Drawing> drawing, PrintWriter terminal) {
    Drawing listed =
        drawing.orElseThrow(
            () -> InputException.of("%s: a picture has no layers, expected a drawing", file));
    PlanOptions.printLayers(file, listed, terminal);
  }

  /**
   * Makes the site.
   *
   * @param name the name of the scenario
   * @param cameras the number of draft cameras
   * @param margin the margin around the drawing, in metres
   * @param drawing the drawing of the walls; empty if there is only a floor plan
   * @param floorplan the picture under the site
   */
  DrawnSite site(
      String name,
      int cameras,
      OptionalDouble margin,
      Optional<Drawing> drawing,
      Optional<Floorplan> floorplan) {
    SiteSettings settings =
        new SiteSettings(
            name,
            file,
            cameras,
            margin,
            OptionalDouble.empty(),
            drawing.map(read -> read.obstacles(options.walkable())).orElse(List.of()),
            floorplan);
    Field drawn = drawing.map(Drawing::field).orElseGet(() -> floorplan.orElseThrow().area());
    List<List<Point>> walkable =
        options.walkable() ? drawing.map(Drawing::walkableBorders).orElse(List.of()) : List.of();
    return new DrawnSite(settings, drawn, walkable);
  }
}
