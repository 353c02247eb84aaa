package org.hificamsim.network.files;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import org.hificamsim.network.statistics.StepFigures;

/** CamSim's table of steps (behaviour 10.1): a row is written when its step is over. */
public final class StepsCsv implements Closeable {
  private static final String HEADER =
      "time;utility;communication;visible;strategy;totUtil;totComm;overlap;confidence;proportion";

  private final Writer out;
  private final StringBuilder row = new StringBuilder();

  /** Starts the table. */
  public StepsCsv(Writer out) throws IOException {
    this.out = out;
    out.write(HEADER + System.lineSeparator());
  }

  /** Writes a row; {@code visible} is 0 in all of them, as in CamSim (quirk Q12). */
  public void write(StepFigures figures) {
    row.setLength(0);
    row.append(figures.step()).append(';');
    row.append(figures.utility()).append(';');
    row.append((double) figures.communication()).append(';');
    row.append(0).append(';');
    row.append(figures.strategyChanges()).append(';');
    row.append(figures.banditUtility()).append(';');
    row.append((double) figures.attempts()).append(';');
    row.append(figures.overlap()).append(';');
    row.append(figures.confidence()).append(';');
    row.append(figures.proportion()).append(System.lineSeparator());
    try {
      out.append(row);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
