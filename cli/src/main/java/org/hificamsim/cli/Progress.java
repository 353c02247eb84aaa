package org.hificamsim.cli;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import org.hificamsim.core.Texts;
import org.hificamsim.profiling.measure.MeasureProgress;
import org.hificamsim.runs.compare.RunProgress;

/**
 * The progress of a long run on standard error: a bar on a terminal, else a line now and then. The
 * launcher says which by {@code -Dhificamsim.terminal=true}. Quiet for the first seconds, so that
 * short runs show nothing.
 */
final class Progress implements RunProgress, MeasureProgress, AutoCloseable {
  private static final long QUIET = TimeUnit.SECONDS.toNanos(2);
  private static final long BETWEEN_LINES = TimeUnit.SECONDS.toNanos(10);
  private static final long BETWEEN_BARS = TimeUnit.MILLISECONDS.toNanos(10);

  /** How progress is shown. */
  enum Telling {
    /** A bar that is drawn again and again. */
    BAR,
    /** A line every ten seconds. */
    LINES,
    NOTHING;

    /** What suits the place that the launcher says standard error is. */
    static Telling asLaunched() {
      return Boolean.getBoolean("hificamsim.terminal") ? BAR : LINES;
    }
  }

  private final String task;
  private final String unit;
  private final long total;
  private final PrintWriter err;
  private final Telling telling;
  private final LongSupplier clock;
  private final AtomicLong done = new AtomicLong();
  private long already;
  private long started;
  private volatile long next; // nanoseconds
  private ProgressBar bar;

  /**
   * @param unit what is counted, as in {@code " steps"}
   * @param total 1 or more
   * @param clock nanoseconds
   */
  Progress(
      String task, String unit, long total, PrintWriter err, Telling telling, LongSupplier clock) {
    this.task = task;
    this.unit = unit;
    this.total = total;
    this.err = err;
    this.telling = telling;
    this.clock = clock;
    this.started = clock.getAsLong();
    this.next = started + (telling == Telling.LINES ? BETWEEN_LINES : QUIET);
  }

  /** Counts one unit; any number of threads may, and mostly none waits for another. */
  @Override
  public void advance() {
    done.incrementAndGet();
    if (telling != Telling.NOTHING && clock.getAsLong() - next > 0) {
      show();
    }
  }

  private synchronized void show() {
    long now = clock.getAsLong();
    if (now - next <= 0) {
      return; // another thread was faster
    }
    if (telling == Telling.BAR) {
      next = now + BETWEEN_BARS;
      bar = bar == null ? bar(now - started) : bar;
      bar.stepTo(done.get());
    } else {
      next = now + BETWEEN_LINES;
      err.println(line(now - started));
    }
  }

  private ProgressBar bar(long elapsed) {
    return new ProgressBarBuilder()
        .setTaskName(task)
        .setUnit(unit, 1)
        .setInitialMax(total)
        .startsFrom(done.get(), Duration.ofNanos(elapsed))
        .setStyle(ProgressBarStyle.ASCII)
        .showSpeed()
        .build();
  }

  /** How much is done, how fast, how long it will take at the mean speed so far. */
  private String line(long elapsed) {
    long now = done.get();
    double perSecond = (now - already) * (double) TimeUnit.SECONDS.toNanos(1) / elapsed;
    long left = (long) Math.ceil((total - now) / perSecond);
    return Texts.format(
        "%s: %d of %d%s (%d%%), %." + (perSecond < 10 ? 1 : 0) + "f%s/s, %d:%02d:%02d left",
        task,
        now,
        total,
        unit,
        100 * now / total,
        perSecond,
        unit,
        left / 3600,
        left / 60 % 60,
        left % 60);
  }

  /** Counts what was done before: it takes no time, and says nothing of the speed. */
  @Override
  public synchronized void resume(long units) {
    done.addAndGet(units);
    already += units;
    if (units > 0) {
      started = clock.getAsLong();
    }
    next = Math.max(next, started + QUIET);
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
