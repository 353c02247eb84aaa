package org.hificamsim.tracks;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.tracks.place.DraftCameras;
import org.hificamsim.tracks.place.PeoplePositions;

/**
 * Makes the scenario of a floor plan without a recording: field, walls, zones, draft of cameras.
 */
public final class DrawnSite {
  private static final int STEPS = 300;

  private final SiteSettings settings;
  private final Field field;
  private final Obstacles obstacles;
  private final List<Zone> zones = new ArrayList<>();
  private final DraftCameras draft;

  /**
   * @param drawn the field around the whole drawing, in metres
   * @param walkable borders of areas that people walk in, which become zones
   */
  public DrawnSite(SiteSettings settings, Field drawn, List<List<Point>> walkable) {
    this.settings = settings;
    this.obstacles = new Obstacles(settings.walls());
    double margin = settings.margin().orElse(0);
    this.field = settings.walls().isEmpty() ? widened(drawn, margin) : rounded(drawn, margin);
    for (List<Point> border : walkable) {
      String name = "inside" + (walkable.size() == 1 ? "" : "-" + (zones.size() + 1));
      zones.add(Zone.of(name, Zone.Shape.POLYGON, border));
    }
    this.draft =
        new DraftCameras(
            field, obstacles, positions(true), settings.cameras(), SiteQuestion.PIXELS_PER_METRE);
  }

  /** Returns the field of a picture, which ends where the picture does, with a margin. */
  private static Field widened(Field picture, double margin) {
    return new Field(
        picture.minX() - margin,
        picture.maxX() + margin,
        picture.minY() - margin,
        picture.maxY() + margin);
  }

  /** Rounds the field of a drawing outwards to metres, so that walls at its end are inside. */
  private static Field rounded(Field drawn, double margin) {
    double minX = Math.floor(drawn.minX() - margin);
    double minY = Math.floor(drawn.minY() - margin);
    return new Field(
        minX,
        Math.max(minX + 1, Math.ceil(drawn.maxX() + margin)),
        minY,
        Math.max(minY + 1, Math.ceil(drawn.maxY() + margin)));
  }

  /**
   * Returns positions all over the zones, or over the field if there are none; on request only free
   * ones.
   */
  PeoplePositions positions(boolean freeOnly) {
    PeoplePositions positions = new PeoplePositions();
    for (Point point :
        PeoplePositions.allOver(field, freeOnly ? obstacles : Obstacles.NONE).points()) {
      if (zones.isEmpty() || zones.stream().anyMatch(zone -> zone.contains(point.x(), point.y()))) {
        positions.add(point.x(), point.y());
      }
    }
    return positions;
  }

  /** The field, in metres. */
  public Field field() {
    return field;
  }

  /** The walls and solids. */
  public Obstacles obstacles() {
    return obstacles;
  }

  /** A warning that no draft camera sees a free position; empty if one does or there are none. */
  Optional<String> blindDraft() {
    return draft.blindnessWarning();
  }

  /** The objective and detection of the scenario, in one line. */
  public String question() {
    return SiteQuestion.line(STEPS);
  }

  /** The scenario, without people. */
  public Scenario scenario() {
    return SiteQuestion.about(settings, field)
        .with(Scenario.STEPS, STEPS)
        .with(Scenario.ZONES, zones)
        .with(Scenario.CAMERAS, draft.cameras());
  }

  /** The XML of this scenario with people. */
  public String xml(Scenario peopled) {
    return SiteQuestion.commented(
        ScenarioWriter.write(peopled),
        "Made by hificamsim site of " + settings.source().getFileName());
  }
}
