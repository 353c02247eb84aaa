package org.hificamsim.core.scenario;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;

/**
 * What becomes of the faults of a scenario file: the first is thrown, or each is reported and
 * reading goes on with the next element.
 */
final class Faults {
  private final Consumer<InputException> report;
  private boolean none = true;

  private Faults(Consumer<InputException> report) {
    this.report = report;
  }

  static Faults thrown() {
    return new Faults(
        fault -> {
          throw fault;
        });
  }

  static Faults reported(Consumer<InputException> report) {
    return new Faults(report);
  }

  /** Whether there has been no fault. */
  boolean none() {
    return none;
  }

  /** A part of the file; empty where it has a fault. */
  <T> Optional<T> of(Supplier<T> part) {
    try {
      return Optional.of(part.get());
    } catch (InputException fault) {
      none = false;
      report.accept(fault);
      return Optional.empty();
    }
  }

  /** Makes a check that may find a fault. */
  void check(Runnable check) {
    of(
        () -> {
          check.run();
          return true;
        });
  }

  /** The elements that have no fault. */
  <T> List<T> each(List<XmlElement> elements, Function<XmlElement, T> reader) {
    return elements.stream().flatMap(one -> of(() -> reader.apply(one)).stream()).toList();
  }
}
