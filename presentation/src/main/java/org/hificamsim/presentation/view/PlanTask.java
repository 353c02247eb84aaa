package org.hificamsim.presentation.view;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.runs.RunFault;

/** Plans cameras on a thread of its own, one plan at a time, while the session goes on. */
final class PlanTask implements Planner.Watcher {
  /**
   * The state of the plan.
   *
   * @param event what happens, or what the last plan meets
   * @param facts the facts that say more of the last plan
   * @param share the share of the work that is done, in [0, 1]
   * @param fault the reason why there is no plan; empty if there is one or it is being made
   */
  record Message(
      boolean running,
      String event,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) List<String> facts,
      double share,
      @JsonInclude(JsonInclude.Include.NON_EMPTY) String fault) {
    private static Message running(String event, double share) {
      return new Message(true, event, List.of(), share, "");
    }

    private static Message failed(String fault) {
      return new Message(false, "", List.of(), 0, Place.printable(fault));
    }
  }

  private final Runnable changed;
  private volatile Message message; // null before the first plan
  private volatile boolean stopped;

  /**
   * @param changed action to run, on any thread, when the message has changed
   */
  PlanTask(Runnable changed) {
    this.changed = changed;
  }

  /** The state; null before the first plan. */
  Message message() {
    return message;
  }

  /**
   * Starts to plan.
   *
   * @param use takes the plan, on the thread of the task
   * @throws InputException if a plan is being made
   */
  synchronized void start(
      Function<Planner.Watcher, Planner.Plan> planning, Consumer<Planner.Plan> use) {
    if (message != null && message.running) {
      throw new InputException("cameras are being planned, expected to wait or to stop that");
    }
    stopped = false;
    show(Message.running("begins", 0));
    Parallel.daemons("plan").newThread(() -> plan(planning, use)).start();
  }

  @SuppressWarnings("CatchingUnchecked") // whatever fails is shown on the page
  private void plan(Function<Planner.Watcher, Planner.Plan> planning, Consumer<Planner.Plan> use) {
    try {
      Planner.Plan plan = planning.apply(this);
      use.accept(plan);
      show(new Message(false, plan.claim(), plan.facts(), 1, ""));
    } catch (InputException e) {
      show(Message.failed(e.getMessage()));
    } catch (RuntimeException | Error e) {
      show(Message.failed(RunFault.describe(e)));
    }
  }

  /** Ends the search of the plan that is being made, if there is one. */
  void stop() {
    stopped = true;
  }

  @Override
  public boolean isStopped() {
    return stopped;
  }

  @Override
  public void progressed(String event, double share) {
    show(Message.running(event, share));
  }

  private void show(Message shown) {
    message = shown;
    changed.run();
  }
}
