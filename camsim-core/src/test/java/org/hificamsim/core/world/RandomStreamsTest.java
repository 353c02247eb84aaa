package org.hificamsim.core.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;

import java.util.Random;
import org.junit.jupiter.api.Test;

class RandomStreamsTest {
  /** Guards the platform: CamSim's generator is java.util.Random. */
  @Test
  void generatorGivesRecordedNumbers() {
    Random doubles = new Random(0);
    assertEquals(0.730967787376657, doubles.nextDouble());
    assertEquals(0.24053641567148587, doubles.nextDouble());
    Random integers = new Random(0);
    assertEquals(60, integers.nextInt(100));
    assertEquals(2, integers.nextInt(7));
    assertEquals(1, integers.nextInt(8));
    Random gaussians = new Random(0);
    assertEquals(0.8025330637390305, gaussians.nextGaussian());
    assertEquals(-0.9015460884175122, gaussians.nextGaussian());
    assertEquals(2.080920790428163, gaussians.nextGaussian());
    Random mixed = new Random(1);
    assertEquals(0.7308781907032909, mixed.nextDouble());
    assertEquals(-0.4123569817689538, mixed.nextGaussian(), 1e-12);
  }

  @Test
  void separateStreamsGiveEqualSequences() {
    RandomStreams streams = new RandomStreams(42);
    assertNotSame(streams.turn(), streams.move());
    for (int i = 0; i < 1000; i++) {
      assertEquals(streams.turn().nextDouble(), streams.move().nextDouble());
    }
    assertEquals(streams.turn().nextGaussian(), streams.move().nextGaussian());
  }

  @Test
  void seedsGiveDifferentSequences() {
    assertNotEquals(
        new RandomStreams(1).turn().nextDouble(), new RandomStreams(2).turn().nextDouble());
  }
}
