package org.hificamsim.cli;

import java.io.PrintWriter;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import org.hificamsim.runs.compare.RunProgress;

/**
 * The progress of a long run on standard error: a bar on a terminal, else a line now and then. The
 * launcher says which by {@code -Dhificamsim.terminal=true}. Quiet for the first seconds, so that
 * short runs show nothing.
 */
final class Progress implements RunProgress, AutoCloseable {
  /** Units between two looks at the clock, at most: more would save nothing. */
  private static final long MAX_UNSEEN = 64;

  /** As often as a look need be, nanoseconds. */
  private static final long SOON = TimeUnit.MILLISECONDS.toNanos(1);

  private static final long QUIET = TimeUnit.SECONDS.toNanos(2);
  private static final long BETWEEN_LINES = TimeUnit.SECONDS.toNanos(10);

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

  private ProgressLine line;
  private final long total;
  private final PrintWriter err;
  private final Telling telling;
  private final LongSupplier clock;
  private long started;
  private final AtomicLong done = new AtomicLong();
  private long unseen = 1;
  private volatile long nextLook;
  private long lastLook;
  private long lastLine;
  private ProgressBar bar;

  /**
   * @param unit what is counted, as in {@code " steps"}
   */
  Progress(String task, String unit, long total, PrintWriter err) {
    this(task, unit, total, err, Telling.asLaunched());
  }

  Progress(String task, String unit, long total, PrintWriter err, Telling telling) {
    this(task, unit, total, err, telling, System::nanoTime);
  }

  /**
   * @param clock nanoseconds
   */
  Progress(
      String task, String unit, long total, PrintWriter err, Telling telling, LongSupplier clock) {
    this.line = new ProgressLine(task, unit.strip(), total);
    this.total = total;
    this.err = err;
    this.telling = telling;
    this.clock = clock;
    this.started = clock.getAsLong();
    this.lastLook = started;
    this.lastLine = started;
    this.nextLook = telling == Telling.NOTHING ? Long.MAX_VALUE : 1;
  }

  /** Counts one unit; any number of threads may, and mostly none waits for another. */
  @Override
  public void advance() {
    if (done.incrementAndGet() >= nextLook) {
      look();
    }
  }

  private synchronized void look() {
    if (done.get() >= nextLook) {
      long now = clock.getAsLong();
      unseen = now - lastLook < SOON ? Math.min(2 * unseen, MAX_UNSEEN) : 1;
      lastLook = now;
      nextLook = done.get() + unseen;
      look(now);
    }
  }

  /** Counts what was done before: it takes no time, and says nothing of the speed. */
  @Override
  public synchronized void resume(long units) {
    done.set(units);
    nextLook = telling == Telling.NOTHING ? Long.MAX_VALUE : units + 1;
    started = clock.getAsLong();
    line = line.after(units);
  }

  private void look(long now) {
    if (now - started < QUIET) {
      return;
    }
    if (telling == Telling.BAR) {
      if (bar == null) {
        bar = bar();
      }
      bar.stepTo(done.get());
    } else if (now - lastLine > BETWEEN_LINES) {
      lastLine = now;
      err.println(line.plain(done.get(), now - started));
    }
  }

  private ProgressBar bar() {
    return new ProgressBarBuilder()
        .setInitialMax(total)
        .setRenderer(
            (state, width) -> line.bar(state.getCurrent(), clock.getAsLong() - started, width))
        .build();
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
