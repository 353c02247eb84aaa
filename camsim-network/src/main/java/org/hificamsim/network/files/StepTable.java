package org.hificamsim.network.files;

import java.io.Closeable;
import java.io.IOException;
import java.io.Writer;
import org.hificamsim.core.file.CsvTable;
import org.hificamsim.core.file.Rows;
import org.hificamsim.network.statistics.StepFigures;

/** A table in CamSim's form: a row for each step. */
final class StepTable implements Closeable {
  private final Rows rows;

  private StepTable(Writer out, String header) throws IOException {
    rows = new CsvTable(out, header, ';', System.lineSeparator());
  }

  /** CamSim's own table of steps (behaviour 10.1). */
  static StepTable camSim(Writer out) throws IOException {
    return new StepTable(
        out,
        "time;utility;communication;visible;strategy;totUtil;totComm;overlap;confidence;proportion");
  }

  /** What its columns {@code visible} and {@code overlap} are taken for (quirks Q11 and Q12). */
  static StepTable extra(Writer out) throws IOException {
    return new StepTable(out, "time;cameras_seeing;overlap_area;handovers");
  }

  /** Writes a row of CamSim's table; {@code visible} is always 0 (quirk Q12). */
  void camSim(StepFigures figures) {
    rows.add(figures.step());
    rows.add(figures.utility());
    rows.add((double) figures.communication());
    rows.add(0);
    rows.add(figures.strategyChanges());
    rows.add(figures.banditUtility());
    rows.add((double) figures.attempts());
    rows.add(figures.overlap());
    rows.add(figures.confidence());
    rows.add(figures.proportion());
    rows.end();
  }

  /**
   * Writes a row of the other table.
   *
   * @param overlap square metres
   */
  void extra(StepFigures figures, double overlap) {
    rows.add(figures.step());
    rows.add(figures.seeing());
    rows.add(overlap);
    rows.add(figures.handovers());
    rows.end();
  }

  @Override
  public void close() throws IOException {
    rows.close();
  }
}
