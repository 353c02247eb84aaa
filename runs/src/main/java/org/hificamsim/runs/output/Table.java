package org.hificamsim.runs.output;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.hificamsim.core.file.NumberRows;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;

/** Every table of results: its file, and its columns, which {@code docs/data.md} explains. */
public enum Table {
  RUN_STEPS("steps.csv", "run,step,k_min,targets,covered_0,covered_1,covered_k,mean_k"),
  RUN_STEPS_BY_CHANCE(
      RUN_STEPS.file,
      RUN_STEPS.columns
          + ",expected_k_min,expected_covered_0,expected_covered_1,expected_covered_k,"
          + "expected_mean_k,least_expected_k,least_chance"),
  RUN_ZOOMS("zooms.csv", "run,step,camera,level,radius,detected"),
  RUN_VIEWS(RUN_ZOOMS.file, RUN_ZOOMS.columns + ",pan,viewing_angle,moving"),
  RUN_TARGETS("targets.csv", "run,step,target,x,y"),
  RUN_TARGETS_BY_CHANCE(RUN_TARGETS.file, RUN_TARGETS.columns + ",k,chance_1,chance_k"),
  HEATMAP(
      "heatmap.csv",
      "column,row,x,y,width,height,mean_k,covered_0,covered_1,covered_k,"
          + "visits,visits_mean_k,visits_covered_0"),
  RESULTS(
      "results.csv",
      "scenario,detection,policy,seed,performance,proportion_of_optimal,"
          + "covered_0,covered_1,covered_k",
      "optimum,objective,score"),
  METRICS("metrics.csv", "scenario,detection,policy,seed,metric,value"),
  SUMMARY(
      "summary.csv",
      "scenario,detection,policy,metric,runs,mean,low,high,"
          + "difference_to,difference,difference_low,difference_high"),
  AGGREGATE("aggregate.csv", "detection,policy,statistic,scenarios,runs,value,low,high"),
  PROFILE("profile.csv", "detection,policy,tau,share,low,high"),
  PAIRS(
      "pairs.csv",
      "scenario,detection,policy,other,metric,runs,difference,low,high,p_value,p_holm"),
  IMPROVEMENT("improvement.csv", "detection,policy,other,scenarios,probability,low,high"),
  STEPS("steps.csv.gz", "scenario,detection,policy,step,k_min"),
  VERDICTS(
      "verdicts.csv",
      "kind,id,source,claim,published,value,low,high,checks,checks_held,verdict,why",
      "role"),
  TABLE_8_1(
      "table-8.1.csv",
      "layout,policy,detection,published,proportion,low,high,difference,verdict,"
          + "over_hifi_optimum,over_hifi_optimum_at_0.45,explore_any,cluster_script_at_origin",
      "eq_6.2,role"),
  ADAPTING("adapting.csv", "scenario,detection,optimum,fixed,value_of_adapting,same_every_step"),
  SENSITIVITY(
      "sensitivity.csv",
      "parameter,value,default,layout,policy,proportion_hifi,proportion_camsim,"
          + "difference,low,high,finding"),
  FIT("fit.csv", "parameter,value,default,error_hifi,error_camsim"),
  LADDER("ladder.csv", "scenario,rung,policy,mean_k_min,low,high,rank"),
  RUNGS(
      "rungs.csv",
      "scenario,rung,optimum,tau,tau_low,tau_high,chosen,regret,regret_low,regret_high,"
          + "share,share_low,share_high");

  private final String file;
  private final String first;
  private final String columns;

  Table(String file, String columns) {
    this(file, columns, "");
  }

  /**
   * @param first the columns of every version, which come first
   * @param added those that older files lack
   */
  Table(String file, String first, String added) {
    this.file = file;
    this.first = first;
    this.columns = added.isEmpty() ? first : first + "," + added;
  }

  /** The file's name. */
  public String file() {
    return file;
  }

  /** The file's name in a format that its tables end in. */
  public String file(String format) {
    return file.replace(".csv", "." + format);
  }

  /** The columns of a table with a row for each step, camera or target of a run. */
  public List<StepColumn> stepColumns() {
    return Arrays.stream(columns.toUpperCase(Locale.ROOT).split(","))
        .map(StepColumn::valueOf)
        .toList();
  }

  /** Starts the table in a folder. */
  public CsvTable create(OutputFolder folder) throws IOException {
    return new CsvTable(folder.open(file), columns.split(","));
  }

  /** Starts the table in a folder, for numbers alone. */
  public NumberRows createRows(OutputFolder folder) throws IOException {
    return new NumberRows(folder.open(file), columns, ',', "\n");
  }

  /** Whether a folder has it. */
  public boolean isIn(Path folder) {
    return Files.isRegularFile(folder.resolve(file));
  }

  /**
   * Reads the table of a folder.
   *
   * @throws org.hificamsim.core.InputException when it is missing, broken or lacks a column
   */
  public CsvRows read(Path folder) {
    return reader(folder).all(required());
  }

  /**
   * Reads the table of a folder row by row, so that any size will do.
   *
   * @param taker takes each row in order
   * @throws org.hificamsim.core.InputException when it is missing, broken or lacks a column
   */
  public void read(Path folder, Consumer<CsvRow> taker) {
    try (CsvReader reader = reader(folder)) {
      reader.header(required());
      reader.each(taker);
    }
  }

  private CsvReader reader(Path folder) {
    return CsvReader.betweenCommas(
        new ResultFolder(folder).file(file), "a table that 'hificamsim' writes");
  }

  private List<String> required() {
    return List.of(first.split(","));
  }

  /** The scenario, detection and policy of a row. */
  public static List<String> caseOf(CsvRow row) {
    return List.of(row.text("scenario"), row.text("detection"), row.text("policy"));
  }
}
