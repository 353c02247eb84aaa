package org.hificamsim.presentation.view;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.presentation.replay.PackedHeat;
import org.hificamsim.presentation.replay.ReplayJson;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.RunFault;

/**
 * A live run on a thread of its own: it steps by the clock and does what commands say between two
 * steps, in their order. Everything that touches the run goes through its queue.
 */
public final class LiveSession implements AutoCloseable {
  private static final int MAX_PER_SECOND = 1000;
  private static final int MAX_STEPS = 1000;

  /** A heat map is sent so often while the simulation runs. */
  private static final long BETWEEN_HEATS = TimeUnit.MILLISECONDS.toNanos(500);

  private static final long LATEST = TimeUnit.MILLISECONDS.toNanos(200);

  /** Who hears what happens, on the session's thread: must not wait for anything. */
  interface Watcher {
    /**
     * The simulations are others.
     *
     * @param json a {@link SetupMessage}
     * @param fresh whether the steps sent before are to be forgotten
     */
    void setup(String json, boolean fresh);

    /** A step has been done. */
    void step(LiveStep step);

    /**
     * Running, speed or fault have changed.
     *
     * @param json a {@link StateMessage}
     */
    void state(String json);

    /**
     * There is another heat map.
     *
     * @param json a list of {@link PackedHeat}, one for each simulation
     */
    void heat(String json);
  }

  /** What runs. */
  record SetupMessage(boolean fresh, List<SideMessage> sides) {}

  /** One simulation. */
  record SideMessage(Setup setup, String estimated) {}

  /**
   * How it runs.
   *
   * @param fault why it has stopped; empty unless a policy or model failed
   * @param held cameras that somebody holds in a view
   * @param heat whether there is a heat map
   */
  record StateMessage(
      boolean running,
      int perSecond,
      long next,
      long seed,
      String fault,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) List<Integer> held,
      @JsonInclude(JsonInclude.Include.NON_DEFAULT) boolean heat) {}

  private final LiveRun run;
  private final LinkedBlockingQueue<Runnable> queue = new LinkedBlockingQueue<>();
  private final List<Watcher> watchers = new ArrayList<>();
  private final int kept;
  private final StepBuffer history;
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
    this.kept = StepBuffer.most(run.sides().get(0).setup());
    this.history = new StepBuffer(kept);
    step();
    thread.setDaemon(true);
    thread.start();
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

  /** Tells somebody all that there is, and from then on whatever happens. */
  void watch(Watcher watcher) {
    queue.add(
        () -> {
          watcher.setup(setup(true), true);
          history.all().forEach(watcher::step);
          watcher.state(state());
          watchers.add(watcher);
          tellHeat();
        });
  }

  /** How many steps are kept for those who come later. */
  int kept() {
    return kept;
  }

  /** Tells somebody nothing more. */
  void unwatch(Watcher watcher) {
    queue.add(() -> watchers.remove(watcher));
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
      tellHeat();
    }
  }

  @SuppressWarnings("CatchingUnchecked") // a user's own policy may fail in any way
  private void step() {
    try {
      LiveStep step = run.step();
      history.add(step);
      watchers.forEach(watcher -> watcher.step(step));
    } catch (RuntimeException | LinkageError | StackOverflowError e) {
      fault = Place.printable("step %s: %s".formatted(run.next(), RunFault.describe(e)));
      running = false;
      tellState();
    }
  }

  void run() {
    running = true;
    fault = "";
    due = System.nanoTime();
    tellState();
  }

  void pause() {
    running = false;
    tellState();
    tellHeat();
  }

  void steps(int steps) {
    between("steps", steps, 1, MAX_STEPS);
    running = false;
    fault = "";
    for (int i = 0; i < steps && fault.isEmpty(); i++) {
      step();
    }
    tellState();
    tellHeat();
  }

  void speed(int newPerSecond) {
    between("perSecond", newPerSecond, 1, MAX_PER_SECOND);
    perSecond = newPerSecond;
    due = System.nanoTime();
    tellState();
  }

  /** Does something to the run that is seen from the next step on. */
  void change(Consumer<LiveRun> change) {
    change.accept(run);
  }

  /** Does something to the run by which it begins again; the first step follows at once. */
  void renew(Consumer<LiveRun> change) {
    change.accept(run);
    history.clear();
    fault = "";
    tellSetup(true);
    step();
    tellHeat();
  }

  void heat(boolean on) {
    run.heat(on);
    heatDue = System.nanoTime();
    tellState();
  }

  void choose(int side, LiveChoice choice) {
    run.choose(side, choice);
    history.replaceAll(step -> step.withoutEstimates(side));
    fault = "";
    tellSetup(false);
  }

  private void tellSetup(boolean fresh) {
    String json = setup(fresh);
    watchers.forEach(watcher -> watcher.setup(json, fresh));
    tellState();
  }

  /** Tells everybody how the run goes on. */
  void tellState() {
    String json = state();
    watchers.forEach(watcher -> watcher.state(json));
  }

  private void tellHeat() {
    if (run.heat() && !watchers.isEmpty()) {
      String json = ReplayJson.of(run.heats());
      watchers.forEach(watcher -> watcher.heat(json));
      heatDue = System.nanoTime() + BETWEEN_HEATS;
    }
  }

  private String setup(boolean fresh) {
    List<SideMessage> sides =
        run.sides().stream().map(side -> new SideMessage(side.setup(), side.estimated())).toList();
    return ReplayJson.of(new SetupMessage(fresh, sides));
  }

  private String state() {
    return ReplayJson.of(
        new StateMessage(
            running, perSecond, run.next(), run.seed(), fault, run.held(), run.heat()));
  }

  private static void between(String name, int value, int least, int most) {
    if (value < least || value > most) {
      throw new InputException(
          "%s is %s, expected a whole number from %s to %s".formatted(name, value, least, most));
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
