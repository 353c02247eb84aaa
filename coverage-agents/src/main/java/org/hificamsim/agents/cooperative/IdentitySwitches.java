package org.hificamsim.agents.cooperative;

import java.util.Arrays;

/**
 * Counts the identity switches of tracks (CLEAR MOT; Bernardin and Stiefelhagen 2008): sightings
 * that were assigned to another track than the sighting of the same target before.
 */
final class IdentitySwitches {
  private static final long NEVER_SEEN = -1;

  private final TargetTracks tracks;

  /** The track of each target's last sighting; see {@link TargetTracks#birth}. */
  private final long[] lastTracks;

  private long count;

  IdentitySwitches(TargetTracks tracks, int targets) {
    this.tracks = tracks;
    lastTracks = new long[targets];
    Arrays.fill(lastTracks, NEVER_SEEN);
  }

  /** Takes in the sightings of a report that the tracks have taken in. */
  void count(SightingReport report) {
    for (int i = 0; i < report.count(); i++) {
      long track = tracks.birth(report.target(i));
      long last = lastTracks[report.trueTarget(i)];
      if (last != NEVER_SEEN && last != track) {
        count++;
      }
      lastTracks[report.trueTarget(i)] = track;
    }
  }

  long count() {
    return count;
  }
}
