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
 * The progress of a long run on standard error: a bar that is drawn again and again on a terminal,
 * else a line now and then. The launcher says which by {@code -Dhificamsim.terminal=true}. Quiet
 * for the first seconds, so that short runs show nothing, and load nothing.
 */
final class Progress implements RunProgress, MeasureProgress, AutoCloseable {
  private static final boolean TERMINAL = Boolean.getBoolean("hificamsim.terminal");
  private static final int BETWEEN_LINES = 10_000; // milliseconds
  private static final int WIDTH = 110; // characters of a line
  private static final Duration BETWEEN = Duration.ofMillis(10); // of two looks at what is done

  /** How long nothing is shown. */
  static final Duration QUIET = TERMINAL ? Duration.ofSeconds(2) : Duration.ofSeconds(10);

  /** For commands that are to be quiet: longer than any runs. */
  static final Duration NEVER = Duration.ofDays(10_000);

  private final String task;
  private final String unit;
  private final long total;
  private final PrintWriter err;
  private final Duration quiet;
  private final AtomicLong done = new AtomicLong();
  private long started = System.nanoTime();
  private volatile long next; // nanoseconds
  private ProgressBar bar;

  /**
   * @param unit what is counted, as in {@code " steps"}
   * @param total 1 or more
   * @param quiet how long nothing is shown
   */
  Progress(String task, String unit, long total, PrintWriter err, Duration quiet) {
    this.task = task;
    this.unit = unit;
    this.total = total;
    this.err = err;
    this.quiet = quiet;
    this.next = started + quiet.toNanos();
  }

  /** Counts one unit; any number of threads may, and mostly none waits for another. */
  @Override
  public void advance() {
    done.incrementAndGet();
    if (System.nanoTime() - next > 0) {
      show();
    }
  }

  private synchronized void show() {
    bar = bar == null ? bar() : bar;
    bar.stepTo(done.get());
    next = System.nanoTime() + BETWEEN.toNanos();
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
            .setUpdateIntervalMillis(BETWEEN_LINES)
            .setConsumer(new DelegatingProgressBarConsumer(err::println, WIDTH))
            .build();
  }

  /** Counts what was done before: it takes no time, and says nothing of the speed. */
  @Override
  public synchronized void resume(long units) {
    done.addAndGet(units);
    started = System.nanoTime();
    next = started + quiet.toNanos();
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
