package org.hificamsim.profiling.measure;

import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Function;
import org.hificamsim.profiling.detector.MemoryNeed;
import org.hificamsim.profiling.detector.ConfidenceSource;
import org.hificamsim.profiling.detector.Detectors;

/** Sets of detectors, each used by one thread at a time. */
final class Toolboxes implements AutoCloseable {
  private final MeasureSettings settings;
  private final Templates templates;
  private final ConcurrentLinkedQueue<List<ConfidenceSource>> free = new ConcurrentLinkedQueue<>();

  Toolboxes(MeasureSettings settings, Templates templates) {
    this.settings = settings;
    this.templates = templates;
  }

  /** What the hungriest detector needs. */
  static MemoryNeed memoryNeed(MeasureSettings settings) {
    List<ConfidenceSource> sources =
        Detectors.sources(settings.detectors(), settings.test(), (object, detector) -> null);
    try {
      return sources.stream()
          .map(ConfidenceSource::memoryNeed)
          .reduce(new MemoryNeed(0, 0), MemoryNeed::max);
    } finally {
      sources.forEach(ConfidenceSource::close);
    }
  }

  <R> R use(Function<List<ConfidenceSource>, R> work) {
    List<ConfidenceSource> taken = free.poll();
    List<ConfidenceSource> detectors =
        taken != null ? taken : Detectors.sources(settings.detectors(), settings.test(), templates);
    try {
      return work.apply(detectors);
    } finally {
      free.add(detectors);
    }
  }

  @Override
  public void close() {
    free.forEach(detectors -> detectors.forEach(ConfidenceSource::close));
  }
}
