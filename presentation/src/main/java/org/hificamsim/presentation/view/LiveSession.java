package org.hificamsim.presentation.view;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.presentation.replay.ReplayJson;
import org.hificamsim.runs.RunFault;

/**
 * A live run on a thread of its own: it steps by the clock and does what commands say between two
 * steps, in their order. Everything that touches the run goes through its queue; pages are shown
 * its feed.
 */
public final class LiveSession implements AutoCloseable {
  private static final int MAX_PER_SECOND = 1000;
  private static final int MAX_STEPS = 1000;

  /** A heat map is shown so often while the simulation runs. */
  private static final long BETWEEN_HEATS = TimeUnit.MILLISECONDS.toNanos(500);

  private static final long LATEST = TimeUnit.MILLISECONDS.toNanos(200);

  /**
   * How it runs.
   *
   * @param fault why it has stopped; empty unless a policy or model failed
   * @param held cameras that somebody holds in a view
   * @param heat whether there is a heat map
   * @param shares what cameras can see of each zone
   * @param warning what is odd about the scenario as it was edited
   */
  private record StateMessage(
      boolean running,
      int perSecond,
      long next,
      long seed,
      String fault,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) List<Integer> held,
      @JsonInclude(JsonInclude.Include.NON_DEFAULT) boolean heat,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) List<Planner.Share> shares,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) String warning) {}

  private final LiveRun run;
  private final LiveFeed feed;
  private final LinkedBlockingQueue<Runnable> queue = new LinkedBlockingQueue<>();
  private final Thread thread = new Thread(this::work, "simulation");
  private final CompletableFuture<Object> end = new CompletableFuture<>();
  private boolean running;
  private int perSecond = 10;
  private long due;
  private String fault = "";
  private long heatDue;

  /** A session that is paused after the first step. */
  public LiveSession(LiveRun run) {
    this.run = run;
    this.feed = LiveFeed.of(run.sides().get(0).setup());
    renew(begun -> {});
    showState();
    thread.setDaemon(true);
    thread.start();
  }

  /** What pages are shown. */
  LiveFeed feed() {
    return feed;
  }

  /**
   * Has a command done.
   *
   * @return completes when it has been done; exceptionally with an {@link InputException} when a
   *     value is wrong, with {@link SessionEnded} when nothing is done any more
   */
  public CompletableFuture<Object> submit(Command command) {
    return inTurn(
        () -> {
          command.obey(this);
          showState();
          showHeat();
          return null;
        });
  }

  /** The scenario with its cameras and walls as commands have put them, as XML. */
  CompletableFuture<Object> scenario() {
    return inTurn(() -> ScenarioWriter.write(run.scenario()));
  }

  private CompletableFuture<Object> inTurn(Supplier<Object> task) {
    CompletableFuture<Object> done = new CompletableFuture<>();
    queue.add(() -> attempt(task, done));
    return CompletableFuture.anyOf(done, end);
  }

  /** Any other error leaves nobody knows what behind: it ends the session. */
  private static void attempt(Supplier<Object> task, CompletableFuture<Object> done) {
    try {
      done.complete(task.get());
    } catch (RuntimeException | LinkageError | StackOverflowError e) {
      done.completeExceptionally(e);
    }
  }

  /** Completes with {@link SessionEnded}, whose cause is the error that has broken it, if any. */
  CompletableFuture<Object> end() {
    return end;
  }

  private void work() {
    try {
      while (!end.isDone()) {
        next();
      }
    } catch (InterruptedException e) {
      close();
    } catch (Error e) {
      end.completeExceptionally(new SessionEnded(e));
    }
  }

  private void next() throws InterruptedException {
    long wait = running ? due - System.nanoTime() : Long.MAX_VALUE;
    Runnable task = queue.poll(Math.max(0, wait), TimeUnit.NANOSECONDS);
    if (task != null) {
      task.run();
    } else if (running) {
      stepByTheClock();
    }
  }

  /** What could not be done in time is not made up for. */
  private void stepByTheClock() {
    long now = System.nanoTime();
    due = Math.max(due, now - LATEST) + TimeUnit.SECONDS.toNanos(1) / perSecond;
    step();
    if (now - heatDue >= 0) {
      showHeat();
    }
  }

  @SuppressWarnings("CatchingUnchecked") // a user's own policy may fail in any way
  private void step() {
    try {
      feed.add(run.step());
    } catch (RuntimeException | LinkageError | StackOverflowError e) {
      fault = Place.printable("step %s: %s".formatted(run.next(), RunFault.describe(e)));
      running = false;
      showState();
    }
  }

  /** Does step after step, until paused. */
  void run() {
    running = true;
    fault = "";
    due = System.nanoTime();
  }

  void pause() {
    running = false;
  }

  /** Does some steps at once, 1 to 1000. */
  void steps(int steps) {
    between("steps", steps, 1, MAX_STEPS);
    running = false;
    fault = "";
    for (int i = 0; i < steps && fault.isEmpty(); i++) {
      step();
    }
  }

  /** Sets how many steps a second are done, 1 to 1000. */
  void speed(int newPerSecond) {
    between("perSecond", newPerSecond, 1, MAX_PER_SECOND);
    perSecond = newPerSecond;
    due = System.nanoTime();
  }

  /** Does something to the run that is seen from the next step on. */
  void change(Consumer<LiveRun> change) {
    change.accept(run);
  }

  /** Does something to the run by which it begins again; the first step follows at once. */
  void renew(Consumer<LiveRun> change) {
    run.paused(!running);
    change.accept(run);
    fault = "";
    feed.begin(sides());
    step();
  }

  void choose(int side, LiveChoice choice) {
    run.choose(side, choice);
    fault = "";
    feed.choose(side, sides());
  }

  private List<LiveFeed.SideMessage> sides() {
    return run.sides().stream()
        .map(side -> new LiveFeed.SideMessage(side.setup(), side.estimated(), side.objective()))
        .toList();
  }

  private void showState() {
    feed.state(
        ReplayJson.of(
            new StateMessage(
                running,
                perSecond,
                run.next(),
                run.seed(),
                fault,
                run.held(),
                run.heat(),
                run.shares(),
                Place.printable(run.warning()))));
  }

  private void showHeat() {
    feed.heat(ReplayJson.of(run.heats()));
    heatDue = System.nanoTime() + BETWEEN_HEATS;
  }

  private static void between(String name, int value, int least, int most) {
    if (value < least || value > most) {
      throw InputException.of(
          "%s is %s, expected a whole number from %s to %s", name, value, least, most);
    }
  }

  /** Ends the thread; no command is done any more. */
  @Override
  public void close() {
    end.completeExceptionally(new SessionEnded());
    thread.interrupt();
  }

  /** No command is done any more: the session was closed, or an error, the cause, has broken it. */
  static final class SessionEnded extends RuntimeException {
    private static final long serialVersionUID = 1L;

    SessionEnded() {
      super("the session has ended");
    }

    SessionEnded(Error cause) {
      super(
          "the session has ended: %s: %s"
              .formatted(cause.getClass().getSimpleName(), cause.getMessage()),
          cause);
    }
  }
}
