package org.hificamsim.runs.output;

import java.util.List;

/** The tables of a run, with a row for each step, camera or target. */
public final class RunTables {
  private static final List<Column<StepCursor>> RUN_AND_STEP =
      Table.<StepCursor>of("")
          .ints("run", "", "the repeat, from 0", row -> row.run)
          .longs("step", "steps", "from 0", row -> row.step)
          .columns();

  private static final Table<StepCursor> UNSCORED =
      Table.<StepCursor>of("steps.csv")
          .with(RUN_AND_STEP)
          .ints(
              "k_min",
              "cameras",
              "the least number of cameras that cover a target (Eq 7.1)",
              row -> row.coverage.kMin())
          .ints("targets", "targets", "present", row -> row.coverage.targets())
          .ints("covered_0", "targets", "that no camera covers", row -> row.coverage.covered0())
          .ints(
              "covered_1",
              "targets",
              "that exactly one camera covers",
              row -> row.coverage.covered1())
          .ints(
              "covered_k",
              "targets",
              "that two or more cameras cover",
              row -> row.coverage.coveredK())
          .doubles(
              "mean_k",
              "cameras",
              "that cover a target, mean; 0 without targets",
              row -> row.coverage.meanK());

  /** A table with a row for each run and step. */
  public static final Table<StepCursor> STEPS = scored(UNSCORED);

  /** A table with a row for each run and step of detections by chance. */
  public static final Table<StepCursor> STEPS_BY_CHANCE =
      scored(
          UNSCORED
              .doubles(
                  "expected_k_min",
                  "cameras",
                  "k_min, expected before luck is drawn",
                  row -> row.coverage.expected().kMin())
              .doubles(
                  "expected_covered_0",
                  "targets",
                  "covered_0, expected",
                  row -> row.coverage.expected().covered0())
              .doubles(
                  "expected_covered_1",
                  "targets",
                  "covered_1, expected",
                  row -> row.coverage.expected().covered1())
              .doubles(
                  "expected_covered_k",
                  "targets",
                  "covered_k, expected",
                  row -> row.coverage.expected().coveredK())
              .doubles(
                  "expected_mean_k",
                  "cameras",
                  "mean_k, expected",
                  row -> row.coverage.expected().meanK())
              .doubles(
                  "least_expected_k",
                  "cameras",
                  "the least expected number of cameras that cover a target",
                  row -> row.coverage.expected().leastK())
              .doubles(
                  "least_chance",
                  "probability",
                  "the least probability of a target to be covered",
                  row -> row.coverage.expected().leastChance()));

  /** A table with a row for each run, step and camera. */
  public static final Table<StepCursor> ZOOMS =
      Table.<StepCursor>of("zooms.csv")
          .with(RUN_AND_STEP)
          .texts("camera", "the camera's name", row -> row.network.cameraName(row.camera))
          .ints(
              "level",
              "",
              "zoom level, 0 is the narrowest",
              row -> row.network.view(row.camera) % row.network.zooms(row.camera))
          .doubles(
              "radius",
              "m",
              "how far the camera detects row this level",
              row -> row.network.zoom(row.camera, row.network.view(row.camera)).radius())
          .ints(
              "detected",
              "targets",
              "that the camera detects",
              row -> row.network.detected(row.camera));

  /** A table with a row for each run, step and camera of scenarios with optics. */
  public static final Table<StepCursor> VIEWS =
      ZOOMS
          .doubles(
              "pan",
              "degrees",
              "of the chosen view, off the mounted heading",
              row -> Math.toDegrees(row.network.pan(row.camera, row.network.view(row.camera))))
          .doubles(
              "viewing_angle",
              "degrees",
              "of the chosen view",
              row ->
                  Math.toDegrees(
                      row.network.zoom(row.camera, row.network.view(row.camera)).viewingAngle()))
          .ints(
              "moving",
              "",
              "1 while the camera is on its way to the view, else 0",
              row -> row.network.moving(row.camera) ? 1 : 0);

  /** A table with a row for each run, step and target. */
  public static final Table<StepCursor> TARGETS =
      Table.<StepCursor>of("targets.csv")
          .with(RUN_AND_STEP)
          .texts("target", "the target's name", row -> row.network.targetName(row.target))
          .doubles("x", "m", "where the target is", row -> row.network.targetX(row.target))
          .doubles("y", "m", "where the target is", row -> row.network.targetY(row.target));

  /** A table with a row for each run, step and target of detections by chance. */
  public static final Table<StepCursor> TARGETS_BY_CHANCE =
      TARGETS
          .ints("k", "cameras", "that cover the target", row -> row.network.coverage(row.target))
          .doubles(
              "chance_1",
              "probability",
              "that one or more cameras cover the target",
              row -> row.coverage.expected().chanceOfOne(row.target))
          .doubles(
              "chance_k",
              "probability",
              "that two or more cameras cover the target",
              row -> row.coverage.expected().chanceOfMore(row.target));

  private RunTables() {}

  /** Adds the score of the step to a table as its last column. */
  private static Table<StepCursor> scored(Table<StepCursor> table) {
    return table.doubles(
        "score",
        "that of the [objective](objectives.md)",
        "the step's score; k_min by default",
        row -> row.coverage.score());
  }

  /** Returns the table of steps for detections by chance or by a threshold. */
  public static Table<StepCursor> steps(boolean byChance) {
    return byChance ? STEPS_BY_CHANCE : STEPS;
  }
}
