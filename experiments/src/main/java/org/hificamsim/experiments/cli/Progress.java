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
  private static final long LOOK_EVERY = 1 << 12;
  private static final long QUIET = TimeUnit.SECONDS.toNanos(2);
  private static final long BETWEEN_LINES = TimeUnit.SECONDS.toNanos(10);

  private final String task;
  private final long total;
  private final PrintWriter err;
  private final long started = System.nanoTime();
  private final boolean terminal = Boolean.getBoolean("hificamsim.terminal");
  private long done;
  private long lastLine = started;
  private ProgressBar bar;

  Progress(String task, long total, PrintWriter err) {
    this.task = task;
    this.total = total;
    this.err = err;
  }

  /** Counts one step. */
  void advance() {
    done++;
    if (done % LOOK_EVERY == 0) {
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
      err.printf("%s: %d of %d steps (%d%%)%n", task, done, total, 100 * done / total);
    }
  }

  private ProgressBar bar() {
    return new ProgressBarBuilder()
        .setTaskName(task)
        .setInitialMax(total)
        .setStyle(ProgressBarStyle.ASCII)
        .setUnit(" steps", 1)
        .showSpeed()
        .build();
  }

  @Override
  public void close() {
    if (bar != null) {
      bar.close();
    }
  }
}
