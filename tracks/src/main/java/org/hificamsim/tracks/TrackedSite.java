package org.hificamsim.tracks;

import java.util.Optional;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.tracks.place.DraftCameras;

/** Makes the scenario of imported tracks: field, draft of cameras, walls, and floor plan. */
public final class TrackedSite {
  /** The default margin, as a share of the longer side. */
  private static final double MARGIN = 0.1;

  /** The least default margin, in metres. */
  private static final double MIN_MARGIN = 1;

  /** The rounding error that is tolerated in the number of steps. */
  private static final double STEP_TOLERANCE = 1e-6;

  private final SiteSettings settings;
  private final Field field;
  private final double interval;
  private final double duration;
  private final Obstacles obstacles;
  private final DraftCameras draft;

  /**
   * @param summary the findings about the tracks
   */
  public TrackedSite(SiteSettings settings, ImportSummary summary) {
    this.settings = settings;
    this.field = field(summary.box());
    this.interval = summary.interval();
    this.duration = summary.duration();
    this.obstacles = new Obstacles(settings.walls());
    this.draft =
        new DraftCameras(
            field,
            obstacles,
            summary.positions(),
            settings.cameras(),
            SiteQuestion.PIXELS_PER_METRE);
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

  /** The field, in metres. */
  public Field field() {
    return field;
  }

  /** The time of a step, in seconds. */
  public double step() {
    return settings.step().orElse(interval);
  }

  /** The number of steps from the first to the last sample, both included. */
  public int steps() {
    return (int) Math.min(Scenario.MAX_STEPS, Math.floor(duration / step() + STEP_TOLERANCE) + 1);
  }

  /** The walls and solids. */
  public Obstacles obstacles() {
    return obstacles;
  }

  /** A warning that no draft camera sees anybody; empty if one does. */
  Optional<String> blindDraft() {
    return draft.blindnessWarning();
  }

  /** The objective, detection and steps of the scenario, in one line. */
  public String question() {
    return SiteQuestion.line(steps());
  }

  /**
   * Returns the scenario as XML.
   *
   * @param tracks the name of the file with the tracks
   */
  public String xml(String tracks) {
    return SiteQuestion.commented(
        ScenarioWriter.write(scenario(), tracks),
        "Made by hificamsim import of " + settings.source().getFileName());
  }

  private Scenario scenario() {
    return SiteQuestion.about(settings, field)
        .with(Scenario.STEPS, steps())
        .with(Scenario.STEP_TIME, step())
        .with(Scenario.CAMERAS, draft.cameras());
  }
}
