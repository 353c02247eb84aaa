package org.hificamsim.presentation.view;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.hificamsim.presentation.replay.ReplayJson;

/**
 * What one open page has yet to receive, as server-sent events. A page that is slow gets fewer
 * steps, never a longer queue: the last one is always among them.
 */
final class EventStream implements LiveSession.Watcher {
  private static final int STEPS_PER_EVENT = 200;
  private static final long HEARTBEAT = 1000;

  /** A comment, which pages ignore: writing it shows whether anybody is there. */
  private static final String NOTHING = ":\n\n";

  private final Semaphore news = new Semaphore(0);
  private final Deque<String> events = new ArrayDeque<>();
  private final StepBuffer steps;
  private String state;
  private String heat;
  private boolean ended;

  /**
   * @param most steps that wait at the same time
   */
  EventStream(int most) {
    this.steps = new StepBuffer(most);
  }

  @Override
  public synchronized void setup(String json, boolean fresh) {
    if (fresh) {
      events.clear();
      steps.clear();
      heat = null;
    } else {
      addSteps();
    }
    events.add(event("setup", json));
    news.release();
  }

  @Override
  public synchronized void step(LiveStep step) {
    steps.add(step);
    news.release();
  }

  @Override
  public synchronized void state(String json) {
    state = event("state", json);
    news.release();
  }

  @Override
  public synchronized void heat(String json) {
    heat = event("heat", json);
    news.release();
  }

  /** Has {@link #take} return null from now on. */
  synchronized void end() {
    ended = true;
    news.release();
  }

  /** Waits for something to send, a second at most; null when the stream has ended. */
  String take() throws InterruptedException {
    if (news.tryAcquire(HEARTBEAT, TimeUnit.MILLISECONDS)) {
      news.drainPermits();
    }
    return next();
  }

  private synchronized String next() {
    if (ended) {
      return null;
    }
    addSteps();
    StringBuilder text = new StringBuilder();
    events.forEach(text::append);
    events.clear();
    if (state != null) {
      text.append(state);
      state = null;
    }
    if (heat != null) {
      text.append(heat);
      heat = null;
    }
    return text.isEmpty() ? NOTHING : text.toString();
  }

  private void addSteps() {
    List<LiveStep> all = steps.drain();
    for (int from = 0; from < all.size(); from += STEPS_PER_EVENT) {
      int to = Math.min(from + STEPS_PER_EVENT, all.size());
      events.add(event("steps", ReplayJson.of(all.subList(from, to))));
    }
  }

  private static String event(String name, String json) {
    return "event: " + name + "\ndata: " + json + "\n\n";
  }
}
