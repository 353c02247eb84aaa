package org.hificamsim.cli;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicLong;
import me.tongfei.progressbar.DelegatingProgressBarConsumer;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import org.hificamsim.profiling.measure.Measurer.MeasureProgress;
import org.hificamsim.runs.compare.RunProgress;

/**
 * Shows the progress of a long run on standard error: as a bar on a terminal, which the launcher
 * announces by {@code -Dhificamsim.terminal=true}, else as a line every ten seconds. It shows
 * nothing in the first seconds, so that short runs print nothing and load no classes for it.
 */
final class Progress implements RunProgress, MeasureProgress, AutoCloseable {
  private static final boolean TERMINAL = Boolean.getBoolean("hificamsim.terminal");
  private static final int MILLISECONDS_BETWEEN_LINES = 10_000;
  private static final int CHARACTERS_PER_LINE = 110;
  private static final Duration BETWEEN_UPDATES = Duration.ofMillis(10);

  /** The time in which nothing is shown. */
  static final Duration INITIAL_DELAY = TERMINAL ? Duration.ofSeconds(2) : Duration.ofSeconds(10);

  /** A delay that is longer than any run, for quiet commands. */
  static final Duration NEVER = Duration.ofDays(10_000);

  private final String task;
  private final String unit;
  private final long total;
  private final PrintWriter err;
  private final Duration quiet;
  private final AtomicLong done = new AtomicLong();
  private long started = System.nanoTime();
  private volatile long nextUpdateNanos;
  private ProgressBar bar;

  /**
   * @param unit the unit that is counted, such as {@code " steps"}
   * @param total the number of units, 1 or more
   * @param quiet the time in which nothing is shown
   */
  Progress(String task, String unit, long total, PrintWriter err, Duration quiet) {
    this.task = task;
    this.unit = unit;
    this.total = total;
    this.err = err;
    this.quiet = quiet;
    this.nextUpdateNanos = started + quiet.toNanos();
  }

  /** Counts one unit. Thread-safe; a thread rarely waits for another. */
  @Override
  public void advance() {
    done.incrementAndGet();
    if (System.nanoTime() - nextUpdateNanos > 0) {
      show();
    }
  }

  private synchronized void show() {
    bar = bar == null ? bar() : bar;
    bar.stepTo(done.get());
    nextUpdateNanos = System.nanoTime() + BETWEEN_UPDATES.toNanos();
  }

  private ProgressBar bar() {
    ProgressBarBuilder builder =
        new ProgressBarBuilder()
            .setTaskName(task)
            .setUnit(unit, 1)
            .setInitialMax(total)
            .startsFrom(done.get(), Duration.ofNanos(System.nanoTime() - started))
            .setStyle(ProgressBarStyle.ASCII)
            .showSpeed();
    return TERMINAL
        ? builder.build()
        : builder
            .setUpdateIntervalMillis(MILLISECONDS_BETWEEN_LINES)
            .setConsumer(new DelegatingProgressBarConsumer(err::println, CHARACTERS_PER_LINE))
            .build();
  }

  /** Counts units that were done before the start, which have no effect on the speed. */
  @Override
  public synchronized void resume(long units) {
    done.addAndGet(units);
    started = System.nanoTime();
    nextUpdateNanos = started + quiet.toNanos();
  }

  @Override
  public synchronized void close() {
    if (bar != null) {
      bar.stepTo(done.get());
      bar.close();
      bar = null;
    }
  }
}
