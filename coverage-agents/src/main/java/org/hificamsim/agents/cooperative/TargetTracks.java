package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.obstacle.Obstacles;

/**
 * Tracks of targets that were seen lately: where each target is now, as far as is known, and how it
 * moves. While no camera sees a target, it is assumed to go on as before, up to the next obstacle.
 */
final class TargetTracks {
  /** The probability of being there below which a target is forgotten. */
  private static final double MIN_WEIGHT = 0.05;

  /** The size of a target whose size is unknown, in metres. */
  private static final double DEFAULT_SIZE = 1;

  private static final class Track {
    private boolean known;

    /** The number of tracks that began before this one. */
    private long birth;

    /** The estimated position of the target, in metres. */
    private double x;

    private double y;

    /** The target's movement in a step, by its last two sightings, in metres. */
    private double stepX;

    private double stepY;

    /** The position and the step of the last sighting. */
    private double seenX;

    private double seenY;
    private long seenAt;
    private double size;
    private double weight;
  }

  private final Parameters parameters;
  private final Obstacles map;
  private Track[] tracks = {};
  private int[] knownTracks = {};
  private int knownCount;
  private double measuredDistance;
  private long measuredSteps;
  private long births;

  TargetTracks(Parameters parameters, Obstacles map, int capacity) {
    this.parameters = parameters;
    this.map = map;
    grow(capacity);
  }

  private void grow(int capacity) {
    tracks = Arrays.copyOf(tracks, capacity);
    knownTracks = Arrays.copyOf(knownTracks, capacity);
    Arrays.setAll(tracks, number -> tracks[number] == null ? new Track() : tracks[number]);
  }

  /** Returns the first number from {@code from} on that no known target has. */
  int unusedNumber(int from) {
    int number = from;
    while (number < tracks.length && tracks[number].known) {
      number++;
    }
    if (number == tracks.length) {
      grow(Math.max(1, 2 * number));
    }
    return number;
  }

  /** The number of targets that are expected to be where their tracks are. */
  double sumOfWeights() {
    double sum = 0;
    for (int i = 0; i < knownCount; i++) {
      sum += tracks[knownTracks[i]].weight;
    }
    return sum;
  }

  /** Moves all targets by one step, and lowers their weights, which a sighting restores. */
  void step() {
    for (int i = 0; i < knownCount; i++) {
      Track track = tracks[knownTracks[i]];
      move(track);
      track.weight *= parameters.decay();
    }
  }

  private void move(Track track) {
    double newX = track.x + track.stepX;
    double newY = track.y + track.stepY;
    if (map.clear(track.x, track.y, newX, newY)) {
      track.x = newX;
      track.y = newY;
    }
  }

  /**
   * Takes in a sighting of a report that identifies targets.
   *
   * @param i the number of the sighting in the report
   * @param now the present step
   * @return whether this is news: no earlier report is of the same step or a later one
   */
  boolean see(SightingReport report, int i, long now) {
    int number = report.target(i);
    Track track = tracks[number];
    long seenAt = report.step();
    if (track.known && track.seenAt >= seenAt) {
      return false;
    }
    if (track.known) {
      measureStep(
          track, seenAt - track.seenAt, report.x(i) - track.seenX, report.y(i) - track.seenY);
    } else {
      track.known = true;
      track.birth = births++;
      knownTracks[knownCount++] = number;
      track.stepX = 0;
      track.stepY = 0;
    }
    track.seenX = report.x(i);
    track.seenY = report.y(i);
    track.seenAt = seenAt;
    track.size = report.size(i) > 0 ? report.size(i) : DEFAULT_SIZE;
    predictPresent(track, now - seenAt);
    return true;
  }

  private void measureStep(Track track, long steps, double dx, double dy) {
    track.stepX = dx / steps;
    track.stepY = dy / steps;
    measuredDistance += Math.sqrt(dx * dx + dy * dy);
    measuredSteps += steps;
  }

  /** Follows a target from its last sighting, with a weight of 1, to the present step. */
  private void predictPresent(Track track, long stepsAgo) {
    track.x = track.seenX;
    track.y = track.seenY;
    track.weight = Math.pow(parameters.decay(), (double) stepsAgo);
    for (long step = 0; step < stepsAgo; step++) {
      move(track);
    }
  }

  /**
   * Takes in that a camera looked at where a target should be, and did not see it: by Bayes' rule
   * the target is less likely to be there.
   *
   * @param chance the chance that the camera would have detected it
   * @return by how much the weight of the target falls
   */
  double miss(int number, double chance) {
    Track track = tracks[number];
    double before = track.weight;
    double detected = before * chance;
    track.weight = detected >= 1 ? 0 : (before - detected) / (1 - detected);
    return before - track.weight;
  }

  /**
   * Forgets the targets that were last seen too long ago, or are hardly there; the search map takes
   * over what is left of their weight.
   */
  void forget(long now, SearchMap searchMap) {
    int kept = 0;
    for (int i = 0; i < knownCount; i++) {
      int number = knownTracks[i];
      Track track = tracks[number];
      track.known = now - track.seenAt <= parameters.memory() && track.weight >= MIN_WEIGHT;
      if (track.known) {
        knownTracks[kept++] = number;
      } else {
        searchMap.absorb(track.x, track.y, track.weight);
      }
    }
    knownCount = kept;
  }

  /** Fills in where a target is going to be: one slot for each step of the forecast. */
  void predict(int number, Forecast forecast, int firstSlot) {
    Track track = tracks[number];
    double x = track.x;
    double y = track.y;
    for (int step = 0; step < forecast.horizon(); step++) {
      forecast.set(firstSlot + step, x, y, track.size, track.weight);
      if (map.clear(x, y, x + track.stepX, y + track.stepY)) {
        x += track.stepX;
        y += track.stepY;
      }
    }
  }

  /** The number of known targets. */
  int count() {
    return knownCount;
  }

  /** The track number of the i-th known target. */
  int track(int i) {
    return knownTracks[i];
  }

  /** The estimated x coordinate of the target, in metres. */
  double x(int number) {
    return tracks[number].x;
  }

  double y(int number) {
    return tracks[number].y;
  }

  /** The estimated x coordinate of the target some steps ago, in metres. */
  double x(int number, long stepsAgo) {
    return tracks[number].x - stepsAgo * tracks[number].stepX;
  }

  double y(int number, long stepsAgo) {
    return tracks[number].y - stepsAgo * tracks[number].stepY;
  }

  /** The size of the target, in metres. */
  double size(int number) {
    return tracks[number].size;
  }

  /** The probability that the target is where it is believed to be, in (0, 1]. */
  double weight(int number) {
    return tracks[number].weight;
  }

  /** A number that distinguishes the track from earlier ones with the same track number. */
  long birth(int number) {
    return tracks[number].birth;
  }

  /** The step in which the target was last seen. */
  long seenAt(int number) {
    return tracks[number].seenAt;
  }

  /** The mean distance that targets move in a step, in metres; 0 before any was seen twice. */
  double meanStepLength() {
    return measuredSteps == 0 ? 0 : measuredDistance / measuredSteps;
  }
}
