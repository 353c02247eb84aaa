package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.runs.RunPlan;

/**
 * An engine that keeps finished runs in a journal, and does not compute again the runs that the
 * journal already has.
 *
 * @param engine the engine that computes the other runs, already configured
 * @param progress the progress, which is notified of each run
 */
public record JournalledEngine(RunEngine engine, Journal journal, RunProgress progress)
    implements RunEngine {
  @Override
  public String name() {
    return engine.name();
  }

  /**
   * {@inheritDoc}
   *
   * <p>Runs in the journal are passed on first, then the others as they finish. A run is added to
   * the journal before it is passed on, so that it is kept even if {@code finished} fails.
   *
   * @throws org.hificamsim.core.InputException when the journal has runs of other inputs of the
   *     same names
   */
  @Override
  public void run(List<RunPlan> plans, List<RunTask> tasks, Finished finished) throws IOException {
    List<RunKey> keys = RunKey.of(plans);
    journal.requireUnchanged(keys);
    List<String> keyTexts = keys.stream().map(RunKey::text).toList();
    List<RunTask> missing = new ArrayList<>();
    for (RunTask task : tasks) {
      Optional<FinishedRun> found = journal.find(keyTexts.get(task.plan()), seed(plans, task));
      if (found.isPresent()) {
        finished.take(task, found.get());
      } else {
        missing.add(task);
      }
    }
    progress.resume(tasks.size() - missing.size());
    engine.run(
        plans,
        missing,
        (task, run) -> {
          journal.add(keyTexts.get(task.plan()), seed(plans, task), run);
          finished.take(task, run);
          progress.advance();
        });
  }

  private static long seed(List<RunPlan> plans, RunTask task) {
    return plans.get(task.plan()).seed(task.repeat());
  }
}
