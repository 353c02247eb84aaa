package org.hificamsim.tracks;

import java.util.Optional;
import java.util.regex.Matcher;
import org.hificamsim.core.Place;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.tracks.place.DraftCameras;
import org.hificamsim.tracks.place.Way;

/** Makes the scenario of imported tracks: field, draft of cameras, walls, and floor plan. */
public final class TrackedSite {
  /** The default margin, as a share of the longer side. */
  private static final double MARGIN = 0.1;

  /** The least default margin, metres. */
  private static final double MIN_MARGIN = 1;

  /** The rounding error that is tolerated in the number of steps. */
  private static final double STEP_TOLERANCE = 1e-6;

  private static final String DETECTION = "oodpcvs-2025:level=discern";
  private static final String OBJECTIVE = "covered:k=1";

  private final SiteSettings settings;
  private final Field field;
  private final double interval;
  private final double duration;
  private final Obstacles obstacles;
  private final Way way;

  /**
   * @param summary of the tracks
   */
  public TrackedSite(SiteSettings settings, ImportSummary summary) {
    this.settings = settings;
    this.field = field(summary.box());
    this.interval = summary.interval();
    this.duration = summary.duration();
    this.obstacles = new Obstacles(settings.walls());
    this.way = summary.way();
  }

  private Field field(Field box) {
    double margin =
        settings
            .margin()
            .orElse(Math.max(MIN_MARGIN, Math.ceil(MARGIN * Math.max(box.width(), box.height()))));
    return new Field(
        Math.floor(box.minX() - margin),
        Math.ceil(box.maxX() + margin),
        Math.floor(box.minY() - margin),
        Math.ceil(box.maxY() + margin));
  }

  /** The field, metres. */
  public Field field() {
    return field;
  }

  /** The time of a step, seconds. */
  public double step() {
    return settings.step().orElse(interval);
  }

  /** The number of steps from the first to the last sample, both included. */
  public int steps() {
    return (int) Math.min(Scenario.MAX_STEPS, Math.floor(duration / step() + STEP_TOLERANCE) + 1);
  }

  private DraftCameras draft() {
    return new DraftCameras(field, obstacles, way);
  }

  /** The walls and solids. */
  public Obstacles obstacles() {
    return obstacles;
  }

  /** Says that no draft camera sees anybody; empty if one does. */
  Optional<String> blindDraft() {
    DraftCameras draft = draft();
    return draft.draw(settings.cameras()).stream()
            .anyMatch(camera -> draft.seen(camera.x(), camera.y()) > 0)
        ? Optional.empty()
        : Optional.of("walls hide everybody from the draft cameras: move these before a run");
  }

  /** The objective, detection and steps of the scenario, in one line. */
  public String question() {
    return "question: " + OBJECTIVE + " by " + DETECTION + " in " + steps() + " steps";
  }

  /**
   * Returns the scenario as XML.
   *
   * @param tracks the name of the file with the tracks
   */
  public String xml(String tracks) {
    String comment = "Made by hificamsim import of " + settings.source().getFileName();
    String safe = Place.printable(comment).replace("--", "- -");
    return ScenarioWriter.write(scenario(), tracks)
        .replaceFirst("\n<root>", Matcher.quoteReplacement("\n<!-- " + safe + " -->\n<root>"));
  }

  private Scenario scenario() {
    Scenario empty =
        new Scenario(settings.name(), field)
            .with(Scenario.ORDER, StepOrder.COVERAGE)
            .with(Scenario.DETECTION, DETECTION)
            .with(Scenario.OBJECTIVE, Objective.parse(OBJECTIVE))
            .with(Scenario.STEPS, steps())
            .with(Scenario.STEP_TIME, step())
            .with(Scenario.OBSTACLES, settings.walls())
            .with(Scenario.CAMERAS, draft().draw(settings.cameras()));
    return settings.floorplan().map(empty::withFloorplan).orElse(empty);
  }
}
