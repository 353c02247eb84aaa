package org.hificamsim.presentation.view;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.presentation.replay.ReplayJson;
import org.hificamsim.runs.RunFault;

/**
 * Runs a live run on a thread of its own: makes steps on schedule and executes commands between
 * them, in order. Everything that touches the run goes through the session's queue; pages read its
 * feed.
 */
public final class LiveSession implements AutoCloseable {
  private static final int MAX_PER_SECOND = 1000;
  private static final int MAX_STEPS = 1000;

  /** The time between two heat maps while the simulation runs, in nanoseconds. */
  private static final long HEAT_INTERVAL = TimeUnit.MILLISECONDS.toNanos(500);

  /** The delay up to which late steps are made up for, in nanoseconds. */
  private static final long MAX_DELAY = TimeUnit.MILLISECONDS.toNanos(200);

  /**
   * The state of the session.
   *
   * @param next the number of the next step
   * @param fault the reason why it has stopped; empty unless a policy or model failed
   * @param held the cameras that are held in a view by hand
   * @param heat whether a heat map is recorded
   * @param zones the zones with the share of each that cameras can see
   * @param plan the plan of cameras that is being made, or was made last; null if there is none
   * @param mountHeight the mount height of all cameras, in metres; null if the scenario gives none
   * @param warning the warning about the edited scenario; may be empty
   */
  private record StateMessage(
      boolean running,
      int perSecond,
      long next,
      long seed,
      String fault,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) List<Integer> held,
      @JsonInclude(JsonInclude.Include.NON_DEFAULT) boolean heat,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) List<ShownZone> zones,
      @JsonInclude(JsonInclude.Include.NON_NULL) PlanTask.Message plan,
      @JsonInclude(JsonInclude.Include.NON_NULL) Double mountHeight,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) String warning) {}

  private final LiveRun run;
  private final LiveFeed feed;
  private final LinkedBlockingQueue<Runnable> queue = new LinkedBlockingQueue<>();
  private final Thread thread = new Thread(this::loop, "simulation");
  private final CompletableFuture<Object> end = new CompletableFuture<>();
  private final PlanTask plan = new PlanTask(() -> queue.add(this::showState));
  private boolean running;
  private int perSecond = 10;
  private long stepDue;
  private String fault = "";
  private long heatDue;

  /** Starts a session, which is paused after the first step. */
  public LiveSession(LiveRun run) {
    this.run = run;
    this.feed = LiveFeed.of(run.sides().get(0).setup());
    renew(unchanged -> {});
    showState();
    thread.setDaemon(true);
    thread.start();
  }

  /** The feed that pages read. */
  LiveFeed feed() {
    return feed;
  }

  /**
   * Executes a command after those that were submitted before.
   *
   * @return completes when the command has been executed; exceptionally with an {@link
   *     InputException} if a value is wrong, with {@link SessionEnded} if the session has ended
   */
  public CompletableFuture<Object> submit(Command command) {
    return enqueue(
        () -> {
          command.execute(this);
          showState();
          showHeat();
          return null;
        });
  }

  /** The scenario with the changes of all commands so far, as XML. */
  CompletableFuture<Object> scenario() {
    return enqueue(() -> ScenarioWriter.write(run.scenario()));
  }

  private CompletableFuture<Object> enqueue(Supplier<Object> task) {
    CompletableFuture<Object> done = new CompletableFuture<>();
    queue.add(() -> attempt(task, done));
    return CompletableFuture.anyOf(done, end);
  }

  /**
   * Executes a task, and passes its result or exception to whoever waits. Other errors may leave
   * the run inconsistent, so they are not caught and end the session.
   */
  private static void attempt(Supplier<Object> task, CompletableFuture<Object> done) {
    try {
      done.complete(task.get());
    } catch (RuntimeException | LinkageError | StackOverflowError e) {
      done.completeExceptionally(e);
    }
  }

  /** Completes with {@link SessionEnded}, whose cause is the error that ended it, if one did. */
  CompletableFuture<Object> end() {
    return end;
  }

  private void loop() {
    try {
      while (!end.isDone()) {
        executeNext();
      }
    } catch (InterruptedException e) {
      close();
    } catch (Error e) {
      end.completeExceptionally(new SessionEnded(e));
    }
  }

  /** Executes the next command, or makes the next step when it is due. */
  private void executeNext() throws InterruptedException {
    long wait = running ? stepDue - System.nanoTime() : Long.MAX_VALUE;
    Runnable task = queue.poll(Math.max(0, wait), TimeUnit.NANOSECONDS);
    if (task != null) {
      task.run();
    } else if (running) {
      stepOnSchedule();
    }
  }

  /** Makes a step. After a long delay, the steps that were missed are not made up for. */
  private void stepOnSchedule() {
    long now = System.nanoTime();
    stepDue = Math.max(stepDue, now - MAX_DELAY) + TimeUnit.SECONDS.toNanos(1) / perSecond;
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

  /** Makes steps until the session is paused. */
  void run() {
    running = true;
    fault = "";
    stepDue = System.nanoTime();
  }

  void pause() {
    running = false;
  }

  /** Makes 1 to 1000 steps at once. */
  void runSteps(int steps) {
    checkRange("steps", steps, 1, MAX_STEPS);
    running = false;
    fault = "";
    for (int i = 0; i < steps && fault.isEmpty(); i++) {
      step();
    }
  }

  /** Sets the steps per second, 1 to 1000. */
  void setSpeed(int newPerSecond) {
    checkRange("perSecond", newPerSecond, 1, MAX_PER_SECOND);
    perSecond = newPerSecond;
    stepDue = System.nanoTime();
  }

  /** Changes the run; the change takes effect in the next step. */
  void change(Consumer<LiveRun> change) {
    change.accept(run);
  }

  /** Makes a change after which the run begins again, and its first step. */
  void renew(Consumer<LiveRun> change) {
    run.setPaused(!running);
    change.accept(run);
    fault = "";
    feed.begin(sides());
    step();
  }

  /** Starts to plan cameras, which replace those of the scenario when they are found. */
  void plan(Planner.Request request) {
    Scenario site = run.scenario();
    plan.start(
        run.planning(request),
        found -> use(live -> live.edit(scenario -> scenario.usePlan(site, found.cameras()))));
  }

  /** Makes a change on the session's thread, and waits for it. */
  private void use(Consumer<LiveRun> change) {
    try {
      enqueue(() -> renewed(change)).get();
    } catch (ExecutionException e) {
      throw new InputException(e.getCause().getMessage(), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private Object renewed(Consumer<LiveRun> change) {
    renew(change);
    showState();
    return null;
  }

  void stopPlan() {
    plan.stop();
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
    feed.showState(
        ReplayJson.of(
            new StateMessage(
                running,
                perSecond,
                run.next(),
                run.seed(),
                fault,
                run.held(),
                run.recordsHeat(),
                run.zones(),
                plan.message(),
                run.scenario().find(Scenario.MOUNT_HEIGHT).orElse(null),
                Place.printable(run.warning()))));
  }

  private void showHeat() {
    feed.showHeat(ReplayJson.of(run.heats()));
    heatDue = System.nanoTime() + HEAT_INTERVAL;
  }

  private static void checkRange(String name, int value, int least, int most) {
    if (value < least || value > most) {
      throw InputException.of(
          "%s is %s, expected a whole number from %s to %s", name, value, least, most);
    }
  }

  /** Ends the thread; further commands are not executed. */
  @Override
  public void close() {
    plan.stop();
    end.completeExceptionally(new SessionEnded());
    thread.interrupt();
  }

  /**
   * Thrown to commands after the end of a session; the cause is the error that ended it, if any.
   */
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
