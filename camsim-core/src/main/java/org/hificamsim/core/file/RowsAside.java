package org.hificamsim.core.file;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Rows that a thread of its own writes, while who adds them goes on: turning numbers into text
 * takes about as long as a step. What goes wrong there is thrown where rows are added later, or at
 * the end.
 */
public final class RowsAside implements Rows {
  private final Rows out;
  private final ExecutorService writer = Executors.newSingleThreadExecutor(RowsAside::thread);
  private CellBatch filled = new CellBatch();
  private CellBatch free = new CellBatch();
  private Future<?> written = CompletableFuture.completedFuture(null);

  /**
   * Starts the thread.
   *
   * @param out what the rows are written with, by that thread alone from now on
   */
  public RowsAside(Rows out) {
    this.out = out;
  }

  /** Rows that are written beside the run where there is a processor for it. */
  public static Rows of(Rows out) {
    return Runtime.getRuntime().availableProcessors() > 1 ? new RowsAside(out) : out;
  }

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work, "rows");
    thread.setDaemon(true);
    return thread;
  }

  @Override
  public void add(long number) {
    room().add(number);
  }

  @Override
  public void add(double number) {
    room().add(number);
  }

  @Override
  public void end() {
    room().end();
  }

  private CellBatch room() {
    if (filled.isFull()) {
      handOver();
    }
    return filled;
  }

  private void handOver() {
    await();
    CellBatch batch = filled;
    filled = free;
    free = batch;
    written = writer.submit(() -> batch.moveTo(out));
  }

  private void await() {
    await(written);
  }

  /** Throws a new exception each time: none can be suppressed by itself. */
  private static void await(Future<?> work) {
    try {
      work.get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new UncheckedIOException(new InterruptedIOException("interrupted"));
    } catch (ExecutionException e) {
      throw failure(e.getCause());
    }
  }

  private static RuntimeException failure(Throwable cause) {
    if (cause instanceof UncheckedIOException unchecked) {
      return new UncheckedIOException(unchecked.getCause());
    }
    return cause instanceof IOException io
        ? new UncheckedIOException(io)
        : new IllegalStateException("rows cannot be written", cause);
  }

  /** Waits until all is written; a second time it does nothing. */
  @Override
  public void close() {
    if (writer.isShutdown()) {
      return;
    }
    try {
      handOver();
      await();
    } finally {
      Future<?> closing = writer.submit(this::closeRows); // by whoever writes them
      writer.shutdown();
      await(closing);
    }
  }

  private Void closeRows() throws IOException {
    out.close();
    return null;
  }
}
