package org.hificamsim.reproduction;

import java.io.IOException;
import java.util.List;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.output.Column;
import org.hificamsim.runs.output.Table;

/** The files of a reproduction: table and verdicts as CSV and Markdown, and the figures. */
public final class ReproductionFiles {
  private static final String ROLE =
      "`fitted`: the defaults were chosen for it (a statement: the hi-fi column implies it, at"
          + " least in part); `held out`: they were not";

  /** A row per scenario and model. */
  public static final Table<AdaptingValue> ADAPTING =
      Table.<AdaptingValue>of("adapting.csv")
          .texts("scenario", "its name", AdaptingValue::scenario)
          .texts("detection", "the detection's name", AdaptingValue::detection)
          .longs(
              "optimum",
              "cameras x steps",
              "performance of `optimal`, summed over the seeds",
              AdaptingValue::optimum)
          .longs("fixed", "cameras x steps", "the same of `fixed:2`", AdaptingValue::fixed)
          .doubles("value_of_adapting", "ratio", "the one over the other", AdaptingValue::value)
          .texts(
              "same_every_step",
              "`true` or `false`: the same k_min at each step",
              adapting -> String.valueOf(adapting.sameEveryStep()));

  /** A row per cell of Table 8.1. */
  public static final Table<Table81.Cell> CELLS =
      Table.<Table81.Cell>of("table-8.1.csv")
          .texts("layout", "the cell's row", cell -> cell.published().layout().label())
          .texts("policy", "the cell's row", cell -> cell.published().policy())
          .texts("detection", "the cell's column", cell -> cell.published().detection())
          .doubles(
              "published",
              "share",
              "the thesis's proportion of the greedy performance",
              cell -> cell.published().proportion())
          .estimates(
              "proportion",
              "",
              "share",
              "ours: a ratio of sums over the random and the scripted scenario",
              Table81.Cell::ours)
          .doubles("difference", "share", "ours minus the published", Table81.Cell::difference)
          .texts(
              "verdict",
              "`reproduced`, `within interval` or `not reproduced`"
                  + " ([rules](reproduction.md#verdicts))",
              cell -> cell.verdict().label())
          .with(reading(Reading.HIFI_OPTIMUM))
          .with(reading(Reading.HIFI_OPTIMUM_AT_45))
          .with(reading(Reading.EXPLORE_ANY))
          .with(reading(Reading.SCRIPT_AT_ORIGIN))
          .with(reading(Reading.EQ_62))
          .texts("role", ROLE, cell -> cell.role().label())
          .with(reading(Reading.ONE_HOP_GREEDY))
          .with(reading(Reading.SIGN_REWARD))
          .with(reading(Reading.LITERAL_REWARD));

  /** A row per reading and detection model. */
  public static final Table<Distance> READINGS =
      Table.<Distance>of("readings.csv")
          .texts(
              "reading",
              "`default`, or the column of `table-8.1.csv` whose cells stand in place of ours where"
                  + " it has any",
              Distance::label)
          .texts(
              "detection",
              "whose nine cells these are: `hi-fi` or `CamSim`",
              distance -> distance.hifi() ? "hi-fi" : "CamSim")
          .doubles(
              "distance", "share", "the mean distance from the published cells", Distance::mean)
          .longs("within", "cells", "how many are at most 0.05 away", Distance::nearCells)
          .ints("steps", "steps", "of each run", Distance::steps)
          .ints("seeds", "", "how many", Distance::seeds);

  /** A row per cell and per statement of the text. */
  public static final Table<JudgedClaim> VERDICTS =
      Table.<JudgedClaim>of("verdicts.csv")
          .texts("kind", "`cell` or `statement`", JudgedClaim::kind)
          .texts("id", "its name", JudgedClaim::id)
          .texts(
              "source",
              "the thesis's section, table or figure; of `tradeoff` the papers",
              JudgedClaim::source)
          .texts("claim", "what it says", JudgedClaim::text)
          .doubles("published", "share", "cells only", JudgedClaim::published)
          .estimates(
              "value",
              "",
              "",
              "a cell's proportion; a statement's weakest margin, in that margin's unit",
              JudgedClaim::value)
          .ints("checks", "", "how many margins there are", JudgedClaim::checks)
          .ints("checks_held", "", "how many of them are above 0", JudgedClaim::held)
          .texts("verdict", "as above", judged -> judged.verdict().label())
          .texts("why", "the reason for it", JudgedClaim::reason)
          .texts("role", ROLE, judged -> judged.role().label());

  private ReproductionFiles() {}

  private static List<Column<Table81.Cell>> reading(Reading reading) {
    return Table.<Table81.Cell>of("")
        .doubles(reading.label(), "share", reading.meaning(), cell -> cell.proportion(reading))
        .columns();
  }

  /**
   * Writes all files.
   *
   * @return the verdicts
   */
  public static Judgement write(OutputFolder folder, List<CaseResult> results) throws IOException {
    Cases cases = new Cases(results);
    RunPlan plan = results.get(0).plan();
    List<Table81.Cell> cells = new Table81(cases).cells();
    Judgement judgement =
        new Judgement(
            cells,
            Distance.of(cells, plan.steps(), plan.repeats()),
            new Statements(cases).judge(),
            AdaptingValue.of(cases));
    ADAPTING.write(folder, judgement.adapting().stream());
    CELLS.write(folder, judgement.cells().stream());
    READINGS.write(folder, judgement.distances().stream());
    VERDICTS.write(folder, judgement.all());
    new ReproductionFigures(cases).write(folder);
    return judgement;
  }
}
