package org.hificamsim.core.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Steps along tracks. */
class TrackWalkTest {
  private static final double STEP = 0.5; // s

  @Test
  void aTargetGoesStraightFromSampleToSample() {
    TrackWalk walk = new TrackWalk();
    walk.begin(new Track(new double[] {1, 10, -10, 2, 14, -4, 4, 6, -4}, STEP), 0);
    double[][] expected = {
      {10, -10}, {10, -10}, {10, -10}, {12, -7}, {14, -4}, {12, -4}, {10, -4}, {8, -4}, {6, -4},
      {6, -4}, {6, -4}
    };
    for (double[] place : expected) {
      assertEquals(place[0], walk.x());
      assertEquals(place[1], walk.y());
      walk.next();
    }
  }

  @Test
  void eachStepIsOnTheLegThatItsTimeFallsInto() {
    SplittableRandom random = new SplittableRandom(1);
    for (int trial = 0; trial < 300; trial++) {
      Track track = new Track(samples(random), STEP);
      long first = random.nextInt(30);
      TrackWalk walk = new TrackWalk();
      walk.begin(track, first);
      for (long step = first; step <= track.lastStep() + 10; step++) {
        double[] place = place(track, step * STEP);
        assertEquals(place[0], walk.x(), 1e-12, () -> "x of " + track);
        assertEquals(place[1], walk.y(), 1e-12, () -> "y of " + track);
        walk.next();
      }
    }
  }

  private static double[] place(Track track, double time) {
    int after = 0;
    while (after < track.samples() && track.time(after) <= time) {
      after++;
    }
    int from = Math.max(0, after - 1);
    int to = Math.min(after, track.samples() - 1);
    double part = from == to ? 0 : (time - track.time(from)) / (track.time(to) - track.time(from));
    return new double[] {
      (1 - part) * track.x(from) + part * track.x(to),
      (1 - part) * track.y(from) + part * track.y(to)
    };
  }

  private static double[] samples(SplittableRandom random) {
    double[] samples = new double[3 * (1 + random.nextInt(6))];
    double time = random.nextDouble(8);
    for (int i = 0; i < samples.length; i += 3) {
      samples[i] = time;
      samples[i + 1] = random.nextDouble(-10, 10);
      samples[i + 2] = random.nextDouble(-10, 10);
      time += random.nextDouble(0.01, 6);
    }
    return samples;
  }
}
