package org.hificamsim.spark;

import java.io.Serializable;
import java.util.ArrayList;
import java.util.List;
import org.apache.spark.TaskContext;
import org.apache.spark.broadcast.Broadcast;
import org.hificamsim.runs.compare.RunTask;
import scala.collection.Iterator;
import scala.runtime.AbstractFunction2;

/** Computes the runs of a partition on an executor, until the first fault. */
final class RunPartition extends AbstractFunction2<TaskContext, Iterator<RunTask>, Answer[]>
    implements Serializable {
  private static final long serialVersionUID = 1L;

  private final Broadcast<PortableComparison> comparison;

  RunPartition(Broadcast<PortableComparison> comparison) {
    this.comparison = comparison;
  }

  @Override
  public Answer[] apply(TaskContext context, Iterator<RunTask> tasks) {
    List<Answer> answers = new ArrayList<>();
    boolean hasFault = false;
    while (!hasFault && tasks.hasNext()) {
      Answer answer = Answer.to(tasks.next(), comparison.value());
      answers.add(answer);
      hasFault = answer.fault() != null;
    }
    return answers.toArray(new Answer[0]);
  }
}
