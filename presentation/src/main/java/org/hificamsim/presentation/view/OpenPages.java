package org.hificamsim.presentation.view;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ScheduledFuture;
import java.util.concurrent.TimeUnit;
import org.hificamsim.core.parallel.Parallel;

/** The pages that are open, and what happens when the last one has been closed for a while. */
final class OpenPages implements AutoCloseable {
  private final int most;
  private final Duration grace;
  private final Runnable end;
  private final List<EventStream> streams = new ArrayList<>();
  private final ScheduledExecutorService clock =
      Executors.newSingleThreadScheduledExecutor(Parallel.daemons("view clock"));
  private ScheduledFuture<?> ending;

  /**
   * @param grace how long no page may be open, after one was, before {@code end} is called: time
   *     for a page to be loaded again
   */
  OpenPages(int most, Duration grace, Runnable end) {
    this.most = most;
    this.grace = grace;
    this.end = end;
  }

  /** Notes that a page listens; false when there are too many. */
  synchronized boolean opened(EventStream stream) {
    if (streams.size() >= most) {
      return false;
    }
    streams.add(stream);
    if (ending != null) {
      ending.cancel(false);
    }
    return true;
  }

  /** Notes that a page has gone. */
  synchronized void closed(EventStream stream) {
    streams.remove(stream);
    if (streams.isEmpty() && !clock.isShutdown()) {
      ending = clock.schedule(end, grace.toMillis(), TimeUnit.MILLISECONDS);
    }
  }

  /** Ends all streams. */
  @Override
  public synchronized void close() {
    clock.shutdownNow();
    streams.forEach(EventStream::end);
  }
}
