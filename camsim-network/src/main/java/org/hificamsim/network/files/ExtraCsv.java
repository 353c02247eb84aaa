package org.hificamsim.network.files;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import org.hificamsim.network.statistics.StepFigures;

/**
 * What CamSim's columns {@code visible} and {@code overlap} are taken for, done right (quirks Q11
 * and Q12), and the handovers of each step.
 */
public final class ExtraCsv implements Closeable {
  private static final String HEADER = "time;cameras_seeing;overlap_area;handovers";

  private final Writer out;

  /** Starts the table. */
  public ExtraCsv(Writer out) throws IOException {
    this.out = out;
    out.write(HEADER + System.lineSeparator());
  }

  /**
   * Writes a row.
   *
   * @param overlap square metres
   */
  public void write(StepFigures figures, double overlap) {
    try {
      out.write(
          figures.step()
              + ";"
              + figures.seeing()
              + ";"
              + overlap
              + ";"
              + figures.handovers()
              + System.lineSeparator());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}
