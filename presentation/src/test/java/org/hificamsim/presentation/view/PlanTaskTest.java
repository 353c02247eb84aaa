package org.hificamsim.presentation.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;

/** Tests planning in the background. */
class PlanTaskTest {
  private static final Planner.Plan PLAN =
      new Planner.Plan(List.of(), "all is met", List.of("proven"));

  private final CompletableFuture<PlanTask.Message> last = new CompletableFuture<>();
  private final PlanTask task = new PlanTask(this::changed);

  private void changed() {
    PlanTask.Message message = task.message();
    if (!message.running()) {
      last.complete(message);
    }
  }

  private PlanTask.Message last() throws Exception {
    return last.get(20, TimeUnit.SECONDS);
  }

  @Test
  void handsOverPlanAndItsSummary() throws Exception {
    assertNull(task.message());
    CompletableFuture<Planner.Plan> used = new CompletableFuture<>();
    task.start(watcher -> PLAN, used::complete);
    assertEquals(new PlanTask.Message(false, "all is met", List.of("proven"), 1, ""), last());
    assertEquals(PLAN, used.get());
  }

  @Test
  void reportsWhyThereIsNoPlan() throws Exception {
    task.start(
        watcher -> {
          throw new InputException("zone 'till' is seen from none of 9 places");
        },
        plan -> {});
    assertEquals("zone 'till' is seen from none of 9 places", last().fault());
  }

  @Test
  void makesOnePlanAtATimeUntilStopped() throws Exception {
    CountDownLatch begun = new CountDownLatch(1);
    task.start(
        watcher -> {
          watcher.progressed("looks", 0.5);
          begun.countDown();
          while (!watcher.isStopped()) {
            Thread.onSpinWait();
          }
          return PLAN;
        },
        plan -> {});
    assertTrue(begun.await(20, TimeUnit.SECONDS));
    assertEquals("looks", task.message().event());
    assertThrows(InputException.class, () -> task.start(watcher -> PLAN, plan -> {}));
    task.stop();
    assertEquals("all is met", last().event());
  }
}
