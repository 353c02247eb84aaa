package org.hificamsim.network.files;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.util.StringJoiner;
import org.hificamsim.network.statistics.StepFigures;

/** A table in CamSim's form: a row is written when its step is over. */
final class StepTable implements Closeable {
  private final Writer out;

  private StepTable(Writer out, String header) {
    this.out = out;
    row(header);
  }

  /** CamSim's own table of steps (behaviour 10.1). */
  static StepTable camSim(Writer out) {
    return new StepTable(
        out,
        "time;utility;communication;visible;strategy;totUtil;totComm;overlap;confidence;proportion");
  }

  /** What its columns {@code visible} and {@code overlap} are taken for (quirks Q11 and Q12). */
  static StepTable extra(Writer out) {
    return new StepTable(out, "time;cameras_seeing;overlap_area;handovers");
  }

  /** Writes a row of CamSim's table; {@code visible} is always 0 (quirk Q12). */
  void camSim(StepFigures figures) {
    row(
        figures.step(),
        figures.utility(),
        (double) figures.communication(),
        0,
        figures.strategyChanges(),
        figures.banditUtility(),
        (double) figures.attempts(),
        figures.overlap(),
        figures.confidence(),
        figures.proportion());
  }

  /**
   * Writes a row of the other table.
   *
   * @param overlap square metres
   */
  void extra(StepFigures figures, double overlap) {
    row(figures.step(), figures.seeing(), overlap, figures.handovers());
  }

  private void row(Object... cells) {
    StringJoiner row = new StringJoiner(";", "", System.lineSeparator());
    for (Object cell : cells) {
      row.add(cell.toString());
    }
    try {
      out.append(row.toString());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
