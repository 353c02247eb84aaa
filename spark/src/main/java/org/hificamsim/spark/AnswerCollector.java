package org.hificamsim.spark;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.hificamsim.runs.compare.RunEngine;
import scala.runtime.AbstractFunction2;
import scala.runtime.BoxedUnit;

/** Takes the answers of partitions on the driver until the first fault. */
final class AnswerCollector extends AbstractFunction2<Object, Answer[], BoxedUnit> {
  private final RunEngine.Finished finished;
  private Exception fault;

  AnswerCollector(RunEngine.Finished finished) {
    this.finished = finished;
  }

  /** {@inheritDoc} A fault is thrown, which ends the job. */
  @Override
  public synchronized BoxedUnit apply(Object partition, Answer[] answers) {
    if (fault == null) {
      try {
        for (Answer answer : answers) {
          take(answer);
        }
      } catch (IOException e) {
        fault = e;
        throw new UncheckedIOException(e);
      } catch (RuntimeException e) {
        fault = e;
        throw e;
      }
    }
    return BoxedUnit.UNIT;
  }

  private void take(Answer answer) throws IOException {
    if (answer.fault() != null) {
      throw answer.fault();
    }
    finished.take(answer.task(), answer.run());
  }

  synchronized boolean isFaulty() {
    return fault != null;
  }

  /** Throws the first fault again, if there was one. */
  synchronized void check() throws IOException {
    if (fault instanceof IOException io) {
      throw io;
    }
    if (fault instanceof RuntimeException other) {
      throw other;
    }
  }
}
