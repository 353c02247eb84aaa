package org.hificamsim.cli;

import java.io.PrintWriter;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.runs.compare.RunProgress;

/**
 * The progress of a long run on standard error: a bar on a terminal, else a line now and then. The
 * launcher says which by {@code -Dhificamsim.terminal=true}. Quiet for the first seconds, so that
 * short runs show nothing.
 */
final class Progress implements RunProgress, AutoCloseable {
  private static final long QUIET = 2; // seconds
  private static final long BETWEEN_LINES = 10;

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

  private final long total;
  private final PrintWriter err;
  private final LongSupplier clock;
  private final AtomicLong done = new AtomicLong();
  private final ScheduledExecutorService timer =
      Executors.newSingleThreadScheduledExecutor(Parallel.daemons("progress"));
  private ProgressLine line;
  private long started;
  private Future<?> showing = CompletableFuture.completedFuture(null);
  private ProgressBar bar;

  /**
   * @param unit what is counted, as in {@code " steps"}
   */
  Progress(String task, String unit, long total, PrintWriter err, Telling telling) {
    this(task, unit, total, err, System::nanoTime);
    switch (telling) {
      case BAR -> showing = timer.schedule(this::showBar, QUIET, TimeUnit.SECONDS);
      case LINES ->
          showing =
              timer.scheduleAtFixedRate(
                  this::printLine, BETWEEN_LINES, BETWEEN_LINES, TimeUnit.SECONDS);
      case NOTHING -> {}
    }
  }

  /**
   * Progress that is shown only when asked for.
   *
   * @param clock nanoseconds
   */
  Progress(String task, String unit, long total, PrintWriter err, LongSupplier clock) {
    this.line = new ProgressLine(task, unit.strip(), total);
    this.total = total;
    this.err = err;
    this.clock = clock;
    this.started = clock.getAsLong();
  }

  /** Counts one unit; any number of threads may. */
  @Override
  public void advance() {
    done.incrementAndGet();
  }

  /** Counts what was done before: it takes no time, and says nothing of the speed. */
  @Override
  public synchronized void resume(long units) {
    done.set(units);
    started = clock.getAsLong();
    line = line.after(units);
  }

  /** Prints a line for a file or a pipe. */
  synchronized void printLine() {
    err.println(line.plain(done.get(), elapsed()));
  }

  private synchronized void showBar() {
    if (!timer.isShutdown()) {
      bar =
          new ProgressBarBuilder()
              .setInitialMax(total)
              .continuousUpdate()
              .setRenderer((state, width) -> line.bar(done.get(), elapsed(), width))
              .build();
    }
  }

  private long elapsed() {
    return clock.getAsLong() - started;
  }

  @Override
  public synchronized void close() {
    showing.cancel(false);
    timer.shutdown();
    if (bar != null) {
      bar.close();
      bar = null;
    }
  }
}
