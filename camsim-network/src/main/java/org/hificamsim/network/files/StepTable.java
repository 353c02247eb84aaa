package org.hificamsim.network.files;

import java.io.Closeable;
import java.io.IOException;
import java.io.Writer;
import org.hificamsim.core.file.CsvTable;
import org.hificamsim.core.file.Rows;
import org.hificamsim.network.statistics.StepFigures;

/** CamSim's table of steps (behaviour 10.1). */
final class StepTable implements Closeable {
  private static final String HEADER =
      "time;utility;communication;visible;strategy;totUtil;totComm;overlap;confidence;proportion";

  private final Rows rows;

  StepTable(Writer out) throws IOException {
    rows = new CsvTable(out, HEADER, ';', System.lineSeparator());
  }

  /** Writes a row; {@code visible} is always 0 (quirk Q12). */
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
