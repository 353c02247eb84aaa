package org.hificamsim.spark;

import java.io.Serializable;
import org.hificamsim.runs.compare.FinishedRun;
import org.hificamsim.runs.compare.RunTask;

/**
 * What came of a task: a finished run, or the fault that a run had. A fault is an answer, since
 * Spark would try a task that throws again and again.
 *
 * @param run null when there is a fault
 * @param fault null when there is none
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
