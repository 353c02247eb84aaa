package org.hificamsim.spark;

import java.io.Serializable;
import org.hificamsim.runs.compare.Outcome;
import org.hificamsim.runs.compare.RunTask;

/**
 * What came of a task: an outcome, or the fault that a run had. A fault is an answer, since Spark
 * would try a task that throws again and again.
 *
 * @param outcome null when there is a fault
 * @param fault null when there is none
 */
record Answer(RunTask task, Outcome outcome, RuntimeException fault) implements Serializable {
  static Answer to(RunTask task, PortableComparison comparison) {
    try {
      return new Answer(task, comparison.outcome(task), null);
    } catch (RuntimeException e) {
      return new Answer(task, null, e);
    }
  }
}
