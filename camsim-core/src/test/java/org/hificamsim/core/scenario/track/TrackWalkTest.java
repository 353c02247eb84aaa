package org.hificamsim.core.scenario.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Tests the positions of a track in each step, computed during the run or in advance. */
class TrackWalkTest {
  private static final double STEP = 0.5; // s

  @Test
  void goesStraightFromSampleToSample() {
    TrackWalk walk = new TrackWalk();
    walk.begin(new Track(new double[] {1, 10, -10, 2, 14, -4, 4, 6, -4}, STEP), 0);
    double[][] expected = {
      {10, -10}, {10, -10}, {10, -10}, {12, -7}, {14, -4}, {12, -4}, {10, -4}, {8, -4}, {6, -4},
      {6, -4}, {6, -4}
    };
    for (double[] position : expected) {
      assertEquals(position[0], walk.x());
      assertEquals(position[1], walk.y());
      walk.next();
    }
  }

  @Test
  void precomputedPositionsEqualComputedOnes() {
    SplittableRandom random = new SplittableRandom(1);
    for (int trial = 0; trial < 300; trial++) {
      List<double[]> samples =
          Stream.generate(() -> samples(random)).limit(1 + random.nextInt(5)).toList();
      List<Track> precomputed = samples.stream().map(values -> new Track(values, STEP)).toList();
      StepPlaces.precompute(precomputed);
      for (int i = 0; i < precomputed.size(); i++) {
        assertNotNull(precomputed.get(i).places());
        assertSameWay(new Track(samples.get(i), STEP), precomputed.get(i), random.nextInt(30));
      }
    }
  }

  @Test
  void doesNotPrecomputeTooManyPositions() {
    double end = (StepPlaces.MAX_PLACES - 1) * STEP;
    Track most = new Track(new double[] {0, 0, 0, end, 8, 4}, STEP);
    Track tooLong = new Track(new double[] {0, 0, 0, end + STEP, 8, 4}, STEP);
    StepPlaces.precompute(List.of(most));
    StepPlaces.precompute(List.of(tooLong));
    assertNotNull(most.places());
    assertNull(tooLong.places());
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

  private static void assertSameWay(Track onTheWay, Track precomputed, long first) {
    TrackWalk expected = new TrackWalk();
    TrackWalk walk = new TrackWalk();
    expected.begin(onTheWay, first);
    walk.begin(precomputed, first);
    for (long step = first; step <= precomputed.lastStep() + 10; step++) {
      assertEquals(expected.x(), walk.x(), () -> "x of " + precomputed);
      assertEquals(expected.y(), walk.y(), () -> "y of " + precomputed);
      expected.next();
      walk.next();
    }
  }
}
