package org.hificamsim.worlds;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;

/** Worlds of a shipped scenario, played with random actions that depend only on world and step. */
final class Played implements AutoCloseable {
  static final Catalogue CATALOGUE = Catalogue.load();

  private final Worlds worlds;
  private final int count;
  private long step;

  Played(WorldSettings settings, int count, int threads, long seed) {
    this.count = count;
    worlds = new Worlds(settings, count, threads, seed, ByteBuffer::allocateDirect);
  }

  static WorldSettings settings(
      String scenario, String reward, ActionKind actions, int steps, boolean auto) {
    return new WorldSettings(
        scenario(scenario),
        null,
        CATALOGUE.movements(),
        Detection.of(CATALOGUE.detection("hifi:orb-lin")),
        ObservationLayout.DEFAULT,
        actions,
        () -> Rewards.registry().create(reward),
        steps,
        auto ? WorldSettings.AutoReset.SAME_STEP : WorldSettings.AutoReset.DISABLED,
        null);
  }

  static Scenario scenario(String name) {
    Path root = Path.of(System.getProperty("hificamsim.root"));
    Path file = root.resolve("scenarios").resolve(name + ".xml");
    return ScenarioReader.read(file, CATALOGUE.movements()::knows, warning -> {});
  }

  Worlds worlds() {
    return worlds;
  }

  /** Runs a step with random actions that are drawn by the seed of each world. */
  void step(long firstSeed) {
    ByteBuffer actions = part("actions");
    int perWorld = actions.capacity() / Integer.BYTES / count;
    int[] choices = worlds.choices().stream().mapToInt(choice -> choice).toArray();
    for (int i = 0; i < count; i++) {
      SplittableRandom random = new SplittableRandom(31 * (firstSeed + i) + step);
      for (int number = 0; number < perWorld; number++) {
        int action = random.nextInt(choices[number % choices.length]);
        actions.putInt((i * perWorld + number) * Integer.BYTES, action);
      }
    }
    worlds.step();
    step++;
  }

  /** Runs a step with the same action for every camera in every world. */
  void stepAll(int... action) {
    ByteBuffer actions = part("actions");
    for (int number = 0; number < actions.capacity() / Integer.BYTES; number++) {
      actions.putInt(number * Integer.BYTES, action[number % action.length]);
    }
    worlds.step();
  }

  ByteBuffer part(String name) {
    return worlds.block().slice(worlds.memory(), name);
  }

  /** Returns the part of a section that belongs to a world. */
  byte[] bytes(String name, int world) {
    ByteBuffer section = part(name);
    byte[] part = new byte[section.capacity() / count];
    section.get(world * part.length, part);
    return part;
  }

  float[] floats(String name, int world) {
    ByteBuffer bytes = ByteBuffer.wrap(bytes(name, world)).order(ByteOrder.nativeOrder());
    float[] numbers = new float[bytes.capacity() / Float.BYTES];
    bytes.asFloatBuffer().get(numbers);
    return numbers;
  }

  /** Hashes everything that a world has written. */
  int hash(int world) {
    int hash = 0;
    for (Block.Section section : worlds.block().sections()) {
      hash = 31 * hash + Arrays.hashCode(bytes(section.name(), world));
    }
    return hash;
  }

  @Override
  public void close() {
    worlds.close();
  }
}
