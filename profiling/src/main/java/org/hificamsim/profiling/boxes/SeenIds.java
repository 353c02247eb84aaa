package org.hificamsim.profiling.boxes;

import java.util.HashSet;
import java.util.Set;
import org.hificamsim.core.Place;

/** Refuses a person that is labelled twice in a frame. */
final class SeenIds {
  private record Id(long frame, String person) {}

  private final Set<Id> ids = new HashSet<>();

  void add(Place place, long frame, String person) {
    if (!ids.add(new Id(frame, person))) {
      throw place.error("id '%s' is in frame %s twice, expected once", person, frame);
    }
  }
}
