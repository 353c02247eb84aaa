package org.hificamsim.network.files;

import java.io.Closeable;
import java.io.IOException;
import java.io.Writer;
import org.hificamsim.core.file.CsvTable;
import org.hificamsim.core.file.Rows;
import org.hificamsim.network.statistics.StepFigures;

/** Writes CamSim's table of steps, a row for each step (behaviour 10.1). */
final class StepTable implements Closeable {
  private final Rows rows;

  /** Writes the header of the table. */
  StepTable(Writer out) throws IOException {
    rows =
        new CsvTable(
            out,
            "time;utility;communication;visible;strategy;totUtil;totComm;overlap;confidence;"
                + "proportion",
            ';',
            System.lineSeparator());
  }

  /** Writes the row of a step; {@code visible} is always 0 (quirk Q12). */
  void add(StepFigures figures) {
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

  @Override
  public void close() throws IOException {
    rows.close();
  }
}
