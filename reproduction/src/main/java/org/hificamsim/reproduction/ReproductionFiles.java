package org.hificamsim.reproduction;

import java.io.IOException;
import java.util.List;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.reproduction.Judgement.Judged;
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
  public static final Table<Adapting> ADAPTING =
      Table.<Adapting>of("adapting.csv")
          .with(
              Column.ofText("scenario", "its name", Adapting::scenario),
              Column.ofText("detection", "the detection's name", Adapting::detection),
              Column.ofLong(
                  "optimum",
                  "cameras x steps",
                  "performance of `optimal`, summed over the seeds",
                  Adapting::optimum),
              Column.ofLong("fixed", "cameras x steps", "the same of `fixed:2`", Adapting::fixed),
              Column.ofDouble(
                  "value_of_adapting", "ratio", "the one over the other", Adapting::value),
              Column.ofText(
                  "same_every_step",
                  "`true` or `false`: the same k_min at each step",
                  one -> "" + one.sameEveryStep()));

  /** A row per cell of Table 8.1. */
  public static final Table<Table81.Cell> CELLS =
      Table.<Table81.Cell>of("table-8.1.csv")
          .with(
              Column.ofText("layout", "the cell's row", cell -> cell.published().layout().label()),
              Column.ofText("policy", "the cell's row", cell -> cell.published().policy()),
              Column.ofText("detection", "the cell's column", cell -> cell.published().detection()),
              Column.ofDouble(
                  "published",
                  "share",
                  "the thesis's proportion of the greedy performance",
                  cell -> cell.published().proportion()))
          .with(
              Column.ofEstimate(
                  "proportion",
                  "low",
                  "high",
                  "share",
                  "ours: a ratio of sums over the random and the scripted scenario",
                  Table81.Cell::ours))
          .with(
              Column.ofDouble(
                  "difference", "share", "ours minus the published", Table81.Cell::difference),
              Column.ofText(
                  "verdict",
                  "`reproduced`, `within interval` or `not reproduced`"
                      + " ([rules](reproduction.md#verdicts))",
                  cell -> cell.verdict().label()),
              Column.ofDouble(
                  "over_hifi_optimum",
                  "share",
                  "CamSim's performance over the hi-fi optimum; empty for hi-fi",
                  Table81.Cell::overHifi),
              Column.ofDouble(
                  "over_hifi_optimum_at_0.45",
                  "share",
                  "the same with CamSim's threshold at 0.45",
                  Table81.Cell::at45),
              Column.ofDouble(
                  "explore_any",
                  "share",
                  "epsilon-greedy whose exploring may draw the best level too; empty for other"
                      + " policies",
                  Table81.Cell::exploreAny),
              Column.ofDouble(
                  "cluster_script_at_origin",
                  "share",
                  "the cluster with its script about the field's centre; empty for other layouts",
                  Table81.Cell::origin),
              Column.<Table81.Cell>ofDouble(
                      "eq_6.2",
                      "share",
                      "CamSim's cells under Eq 6.2 as printed, over its own optimum; empty for"
                          + " hi-fi",
                      Table81.Cell::standard)
                  .later(),
              Column.<Table81.Cell>ofText("role", ROLE, cell -> cell.role().label()).later());

  /** A row per cell and per statement of the text. */
  public static final Table<Judged> VERDICTS =
      Table.<Judged>of("verdicts.csv")
          .with(
              Column.ofText("kind", "`cell` or `statement`", Judged::kind),
              Column.ofText("id", "its name", Judged::id),
              Column.ofText("source", "the thesis's section, table or figure", Judged::source),
              Column.ofText("claim", "what it says", Judged::text),
              Column.ofDouble("published", "share", "cells only", Judged::published))
          .with(
              Column.ofEstimate(
                  "value",
                  "low",
                  "high",
                  "",
                  "a cell's proportion; a statement's weakest margin, in that margin's unit",
                  Judged::value))
          .with(
              Column.ofInt("checks", "", "how many margins there are", Judged::checks),
              Column.ofInt("checks_held", "", "how many of them are above 0", Judged::held),
              Column.ofText("verdict", "as above", one -> one.verdict().label()),
              Column.ofText("why", "the reason for it", Judged::reason),
              Column.<Judged>ofText("role", ROLE, one -> one.role().label()).later());

  private ReproductionFiles() {}

  /**
   * Writes all files.
   *
   * @return the judged table and statements
   */
  public static Judgement write(OutputFolder folder, List<CaseResult> results) throws IOException {
    Cases cases = new Cases(results);
    Judgement judgement =
        new Judgement(
            new Table81(cases).cells(), new Statements(cases).judged(), Adapting.of(cases));
    ADAPTING.write(folder, judgement.adapting().stream());
    CELLS.write(folder, judgement.cells().stream());
    VERDICTS.write(folder, judgement.all());
    new ReproductionFigures(cases).write(folder);
    return judgement;
  }
}
