package org.hificamsim.runs.output;

import java.util.List;

/** The tables of a run, with a row for each step, camera or target. */
public final class RunTables {
  private static final List<Column<StepCursor>> RUN_AND_STEP =
      Table.<StepCursor>of("")
          .ints("run", "", "the repeat, from 0", at -> at.run)
          .longs("step", "steps", "from 0", at -> at.step)
          .columns();

  private static final Table<StepCursor> UNSCORED =
      Table.<StepCursor>of("steps.csv")
          .with(RUN_AND_STEP)
          .ints(
              "k_min",
              "cameras",
              "the least number of cameras that cover a target (Eq 7.1)",
              at -> at.coverage.kMin())
          .ints("targets", "targets", "present", at -> at.coverage.targets())
          .ints("covered_0", "targets", "that no camera covers", at -> at.coverage.covered0())
          .ints(
              "covered_1",
              "targets",
              "that exactly one camera covers",
              at -> at.coverage.covered1())
          .ints(
              "covered_k",
              "targets",
              "that two or more cameras cover",
              at -> at.coverage.coveredK())
          .doubles(
              "mean_k",
              "cameras",
              "that cover a target, mean; 0 without targets",
              at -> at.coverage.meanK());

  /** A row per run and step. */
  public static final Table<StepCursor> STEPS = scored(UNSCORED);

  /** A row per run and step of detections by chance. */
  public static final Table<StepCursor> STEPS_BY_CHANCE =
      scored(
          UNSCORED
              .doubles(
                  "expected_k_min",
                  "cameras",
                  "k_min as it was to be expected before luck was drawn",
                  at -> at.coverage.expected().kMin())
              .doubles(
                  "expected_covered_0",
                  "targets",
                  "covered_0, expected",
                  at -> at.coverage.expected().covered0())
              .doubles(
                  "expected_covered_1",
                  "targets",
                  "covered_1, expected",
                  at -> at.coverage.expected().covered1())
              .doubles(
                  "expected_covered_k",
                  "targets",
                  "covered_k, expected",
                  at -> at.coverage.expected().coveredK())
              .doubles(
                  "expected_mean_k",
                  "cameras",
                  "mean_k, expected",
                  at -> at.coverage.expected().meanK())
              .doubles(
                  "least_expected_k",
                  "cameras",
                  "the least expected number of cameras that cover a target",
                  at -> at.coverage.expected().leastK())
              .doubles(
                  "least_chance",
                  "probability",
                  "the least one of a target to be covered",
                  at -> at.coverage.expected().leastChance()));

  /** A row per run, step and camera. */
  public static final Table<StepCursor> ZOOMS =
      Table.<StepCursor>of("zooms.csv")
          .with(RUN_AND_STEP)
          .texts("camera", "the camera's name", at -> at.network.cameraName(at.camera))
          .ints(
              "level",
              "",
              "zoom level, 0 is the narrowest",
              at -> at.network.view(at.camera) % at.network.zooms(at.camera))
          .doubles(
              "radius",
              "m",
              "how far the camera detects at this level",
              at -> at.network.zoom(at.camera, at.network.view(at.camera)).radius())
          .ints(
              "detected",
              "targets",
              "that the camera detects",
              at -> at.network.detected(at.camera));

  /** A row per run, step and camera of scenarios with optics. */
  public static final Table<StepCursor> VIEWS =
      ZOOMS
          .doubles(
              "pan",
              "degrees",
              "of the chosen view, off the mounted heading",
              at -> Math.toDegrees(at.network.pan(at.camera, at.network.view(at.camera))))
          .doubles(
              "viewing_angle",
              "degrees",
              "of the chosen view",
              at ->
                  Math.toDegrees(
                      at.network.zoom(at.camera, at.network.view(at.camera)).viewingAngle()))
          .ints(
              "moving",
              "",
              "1 while the camera is on its way to the view, else 0",
              at -> at.network.moving(at.camera) ? 1 : 0);

  /** A row per run, step and target. */
  public static final Table<StepCursor> TARGETS =
      Table.<StepCursor>of("targets.csv")
          .with(RUN_AND_STEP)
          .texts("target", "the target's name", at -> at.network.targetName(at.target))
          .doubles("x", "m", "where the target is", at -> at.network.targetX(at.target))
          .doubles("y", "m", "where the target is", at -> at.network.targetY(at.target));

  /** A row per run, step and target of detections by chance. */
  public static final Table<StepCursor> TARGETS_BY_CHANCE =
      TARGETS
          .ints("k", "cameras", "that cover the target", at -> at.network.coverage(at.target))
          .doubles(
              "chance_1",
              "probability",
              "that one or more cameras cover the target",
              at -> at.coverage.expected().chanceOfOne(at.target))
          .doubles(
              "chance_k",
              "probability",
              "that two or more cameras cover the target",
              at -> at.coverage.expected().chanceOfMore(at.target));

  private RunTables() {}

  /** A table with the score of the step as its last column. */
  private static Table<StepCursor> scored(Table<StepCursor> table) {
    return table.doubles(
        "score",
        "that of the [objective](objectives.md)",
        "what the objective makes of the step; k_min by default",
        at -> at.coverage.score());
  }

  /** The table of steps for detections by chance, or for others. */
  public static Table<StepCursor> steps(boolean byChance) {
    return byChance ? STEPS_BY_CHANCE : STEPS;
  }
}
