package org.hificamsim.experiments.cli;

import java.io.PrintWriter;
import java.util.concurrent.TimeUnit;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;

/**
 * The progress of a long run on standard error: a bar on a terminal, else a line now and then. The
 * launcher says which by {@code -Dhificamsim.terminal=true}. Quiet for the first seconds, so that
 * short runs show nothing.
 */
final class Progress implements AutoCloseable {
  private static final long MOST_UNSEEN = 1 << 12;
  private static final long QUIET = TimeUnit.SECONDS.toNanos(2);
  private static final long BETWEEN_LINES = TimeUnit.SECONDS.toNanos(10);

  private final String task;
  private final String unit;
  private final long total;
  private final long lookEvery;
  private final PrintWriter err;
  private final long started = System.nanoTime();
  private final boolean terminal = Boolean.getBoolean("hificamsim.terminal");
  private long done;
  private long lastLine = started;
  private ProgressBar bar;

  /**
   * @param unit what is counted, as in {@code " steps"}
   */
  Progress(String task, String unit, long total, PrintWriter err) {
    this.task = task;
    this.unit = unit;
    this.total = total;
    this.lookEvery = Math.max(1, Math.min(MOST_UNSEEN, total / 1000));
    this.err = err;
  }

  /** Counts one unit. */
  synchronized void advance() {
    done++;
    if (done % lookEvery == 0) {
      look(System.nanoTime());
    }
  }

  private void look(long now) {
    if (now - started < QUIET) {
      return;
    }
    if (terminal) {
      if (bar == null) {
        bar = bar();
      }
      bar.stepTo(done);
    } else if (now - lastLine > BETWEEN_LINES) {
      lastLine = now;
      err.printf("%s: %d of %d%s (%d%%)%n", task, done, total, unit, 100 * done / total);
    }
  }

  private ProgressBar bar() {
    return new ProgressBarBuilder()
        .setTaskName(task)
        .setInitialMax(total)
        .setStyle(ProgressBarStyle.ASCII)
        .setUnit(unit, 1)
        .showSpeed()
        .build();
  }

  @Override
  public synchronized void close() {
    if (bar != null) {
      bar.stepTo(done);
      bar.close();
      bar = null;
    }
  }
}
