package org.hificamsim.tracks;

import java.util.regex.Matcher;
import org.hificamsim.core.Place;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.tracks.place.DraftCameras;

/** The scenario around imported tracks: field, cameras as a first draft, walls, floor plan. */
public final class TrackedSite {
  private static final double MARGIN = 0.1; // of the longer side
  private static final double LEAST = 1; // m
  private static final double ROUNDING = 1e-6; // of a step
  private static final String DETECTION = "oodpcvs-2025:level=discern";
  private static final String OBJECTIVE = "covered:k=1";

  private final SiteSettings settings;
  private final Field field;
  private final double interval;
  private final double duration;

  /**
   * @param found what the tracks have in them
   */
  public TrackedSite(SiteSettings settings, ImportSummary found) {
    this.settings = settings;
    this.field = field(found.box());
    this.interval = found.interval();
    this.duration = found.duration();
  }

  private Field field(Field box) {
    double margin =
        settings
            .margin()
            .orElse(Math.max(LEAST, Math.ceil(MARGIN * Math.max(box.width(), box.height()))));
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

  /** How long a step takes, seconds. */
  public double step() {
    return settings.step().orElse(interval);
  }

  /** How many steps there are from the first to the last sample, both included. */
  public int steps() {
    return (int) Math.min(Scenario.MAX_STEPS, Math.floor(duration / step() + ROUNDING) + 1);
  }

  /** What the scenario asks, in a line. */
  public String question() {
    return "question: " + OBJECTIVE + " by " + DETECTION + " in " + steps() + " steps";
  }

  /** The scenario's file, which names that of the tracks. */
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
            .with(
                Scenario.CAMERAS,
                DraftCameras.of(settings.cameras(), field, new Obstacles(settings.walls())));
    return settings.floorplan().map(empty::withFloorplan).orElse(empty);
  }
}
