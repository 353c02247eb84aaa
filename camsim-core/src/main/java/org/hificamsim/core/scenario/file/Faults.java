package org.hificamsim.core.scenario.file;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.xml.XmlElement;

/**
 * Handles the faults of a scenario file: throws the first one, or reports each one so that reading
 * goes on with the next element.
 */
public final class Faults {
  private final Consumer<InputException> report;
  private boolean none = true;

  private Faults(Consumer<InputException> report) {
    this.report = report;
  }

  /** Creates faults of which the first one is thrown. */
  public static Faults thrown() {
    return new Faults(
        fault -> {
          throw fault;
        });
  }

  /** Creates faults that are all reported. */
  public static Faults reported(Consumer<InputException> report) {
    return new Faults(report);
  }

  /** Whether there has been no fault. */
  public boolean none() {
    return none;
  }

  /** Returns a part of the file, or a substitute if reading the part finds a fault. */
  public <T> T or(T substitute, Supplier<T> part) {
    try {
      return part.get();
    } catch (InputException fault) {
      none = false;
      report.accept(fault);
      return substitute;
    }
  }

  /** Runs a check and handles the fault that it may find. */
  public void check(Runnable check) {
    or(
        none,
        () -> {
          check.run();
          return none;
        });
  }

  /** Reads each element, and keeps the results of those without a fault. */
  public <T> List<T> each(List<XmlElement> elements, Function<XmlElement, T> reader) {
    List<T> read = new ArrayList<>();
    elements.forEach(element -> check(() -> read.add(reader.apply(element))));
    return read;
  }
}
