package org.hificamsim.spark;

import java.io.Serializable;
import org.hificamsim.runs.compare.FinishedRun;
import org.hificamsim.runs.compare.RunTask;

/**
 * The answer of a task: a finished run, or the fault that ended it. A fault is returned, because
 * Spark would retry a task that throws.
 *
 * @param run the finished run; null if there is a fault
 * @param fault the fault; null if there is none
 */
record Answer(RunTask task, FinishedRun run, RuntimeException fault) implements Serializable {
  static Answer to(RunTask task, PortableComparison comparison) {
    try {
      return new Answer(task, comparison.run(task), null);
    } catch (RuntimeException e) {
      return new Answer(task, null, e);
    }
  }
}
