package org.hificamsim.runs.output;

import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.function.ToIntFunction;
import org.hificamsim.core.metrics.ExpectedCoverage;
import org.hificamsim.core.metrics.StepCoverage;

/** The tables of a run, with a row for each step, camera or target. */
public final class RunTables {
  private static final List<Column<StepCursor>> WHICH =
      List.of(
          Column.ofInt("run", "", "the repeat, from 0", at -> at.run),
          Column.ofLong("step", "steps", "from 0", at -> at.step));

  /** What the objective makes of a step; a recording does not know it. */
  private static final Column<StepCursor> SCORE =
      Column.<StepCursor>ofDouble(
              "score",
              "that of the [objective](objectives.md)",
              "what the objective makes of the step; k_min by default",
              at -> at.coverage.score())
          .later();

  /** A row per run and step, as far as a recording knows it. */
  public static final Table<StepCursor> RECORDED =
      Table.<StepCursor>of("steps.csv")
          .with(WHICH)
          .with(
              counted(
                  "k_min",
                  "cameras",
                  "the least number of cameras that cover a target (Eq 7.1)",
                  StepCoverage::kMin),
              counted("targets", "targets", "present", StepCoverage::targets),
              counted("covered_0", "targets", "that no camera covers", StepCoverage::covered0),
              counted(
                  "covered_1", "targets", "that exactly one camera covers", StepCoverage::covered1),
              counted(
                  "covered_k", "targets", "that two or more cameras cover", StepCoverage::coveredK),
              Column.ofDouble(
                  "mean_k",
                  "cameras",
                  "that cover a target, mean; 0 without targets",
                  at -> at.coverage.meanK()));

  /** A row per run and step. */
  public static final Table<StepCursor> STEPS = RECORDED.with(SCORE);

  /** The same where detections are by chance. */
  public static final Table<StepCursor> STEPS_BY_CHANCE =
      RECORDED
          .with(
              expected(
                  "expected_k_min",
                  "cameras",
                  "k_min as it was to be expected before luck was drawn",
                  ExpectedCoverage::kMin),
              expected(
                  "expected_covered_0",
                  "targets",
                  "covered_0, expected",
                  ExpectedCoverage::covered0),
              expected(
                  "expected_covered_1",
                  "targets",
                  "covered_1, expected",
                  ExpectedCoverage::covered1),
              expected(
                  "expected_covered_k",
                  "targets",
                  "covered_k, expected",
                  ExpectedCoverage::coveredK),
              expected("expected_mean_k", "cameras", "mean_k, expected", ExpectedCoverage::meanK),
              expected(
                  "least_expected_k",
                  "cameras",
                  "the least expected number of cameras that cover a target",
                  ExpectedCoverage::leastK),
              expected(
                  "least_chance",
                  "probability",
                  "the least one of a target to be covered",
                  ExpectedCoverage::leastChance))
          .with(SCORE);

  /** A row per run, step and camera. */
  public static final Table<StepCursor> ZOOMS =
      Table.<StepCursor>of("zooms.csv")
          .with(WHICH)
          .with(
              Column.ofText("camera", "the camera's name", at -> at.network.cameraName(at.camera)),
              Column.ofInt(
                  "level",
                  "",
                  "zoom level, 0 is the narrowest",
                  at -> at.network.view(at.camera) % at.network.zooms(at.camera)),
              Column.ofDouble(
                  "radius",
                  "m",
                  "how far the camera detects at this level",
                  at -> at.network.zoom(at.camera, at.network.view(at.camera)).radius()),
              Column.ofInt(
                  "detected",
                  "targets",
                  "that the camera detects",
                  at -> at.network.detected(at.camera)));

  /** The same where cameras have optics. */
  public static final Table<StepCursor> VIEWS =
      ZOOMS.with(
          Column.ofDouble(
              "pan",
              "degrees",
              "of the chosen view, off the mounted heading",
              at -> Math.toDegrees(at.network.pan(at.camera, at.network.view(at.camera)))),
          Column.ofDouble(
              "viewing_angle",
              "degrees",
              "of the chosen view",
              at ->
                  Math.toDegrees(
                      at.network.zoom(at.camera, at.network.view(at.camera)).viewingAngle())),
          Column.ofInt(
              "moving",
              "",
              "1 while the camera is on its way to the view, else 0",
              at -> at.network.moving(at.camera) ? 1 : 0));

  /** A row per run, step and target. */
  public static final Table<StepCursor> TARGETS =
      Table.<StepCursor>of("targets.csv")
          .with(WHICH)
          .with(
              Column.ofText("target", "the target's name", at -> at.network.targetName(at.target)),
              Column.ofDouble(
                  "x", "m", "where the target is", at -> at.network.oracle().targetX(at.target)),
              Column.ofDouble(
                  "y", "m", "where the target is", at -> at.network.oracle().targetY(at.target)));

  /** The same where detections are by chance. */
  public static final Table<StepCursor> TARGETS_BY_CHANCE =
      TARGETS.with(
          Column.ofInt(
              "k", "cameras", "that cover the target", at -> at.network.coverage(at.target)),
          Column.ofDouble(
              "chance_1",
              "probability",
              "that one or more cameras cover the target",
              at -> at.coverage.expected().chanceOfOne(at.target)),
          Column.ofDouble(
              "chance_k",
              "probability",
              "that two or more cameras cover the target",
              at -> at.coverage.expected().chanceOfMore(at.target)));

  private RunTables() {}

  /** The table of steps where detections are so. */
  public static Table<StepCursor> steps(boolean byChance) {
    return byChance ? STEPS_BY_CHANCE : STEPS;
  }

  private static Column<StepCursor> counted(
      String name, String unit, String meaning, ToIntFunction<StepCoverage> count) {
    return Column.ofInt(name, unit, meaning, at -> count.applyAsInt(at.coverage));
  }

  private static Column<StepCursor> expected(
      String name, String unit, String meaning, ToDoubleFunction<ExpectedCoverage> figure) {
    return Column.ofDouble(name, unit, meaning, at -> figure.applyAsDouble(at.coverage.expected()));
  }
}
