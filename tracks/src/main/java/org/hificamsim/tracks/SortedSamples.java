package org.hificamsim.tracks;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;

/** Sorted parts, merged as they are read: by target, then by part, whose samples came earlier. */
final class SortedSamples {
  private record Numbered(int number, SampleRun run) {}

  private final PriorityQueue<Numbered> open =
      new PriorityQueue<>(
          Comparator.<Numbered>comparingInt(one -> one.run().target())
              .thenComparingInt(Numbered::number));
  private Numbered now;

  SortedSamples(List<SampleRun> runs) {
    List<Numbered> begun = new ArrayList<>();
    for (SampleRun run : runs) {
      begun.add(new Numbered(begun.size(), run));
    }
    begun.stream().filter(one -> one.run().next()).forEach(open::add);
  }

  /** Goes to the next sample; false at the end. */
  boolean next() {
    if (now != null && now.run().next()) {
      open.add(now);
    }
    now = open.poll();
    return now != null;
  }

  /** The sample: its target, tick, x and y. */
  SampleRun sample() {
    return now.run();
  }
}
