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

/** Worlds of a shipped scenario, played with random actions that depend on world and step alone. */
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

  /** One step of actions that are drawn by the seed of each world. */
  void step(long firstSeed) {
    ByteBuffer actions = part("actions");
    int each = actions.capacity() / Integer.BYTES / count;
    int[] choices = worlds.choices().stream().mapToInt(choice -> choice).toArray();
    for (int i = 0; i < count; i++) {
      SplittableRandom random = new SplittableRandom(31 * (firstSeed + i) + step);
      for (int at = 0; at < each; at++) {
        int action = random.nextInt(choices[at % choices.length]);
        actions.putInt((i * each + at) * Integer.BYTES, action);
      }
    }
    worlds.step();
    step++;
  }

  /** The same action for every camera in every world. */
  void stepAll(int... action) {
    ByteBuffer actions = part("actions");
    for (int at = 0; at < actions.capacity() / Integer.BYTES; at++) {
      actions.putInt(at * Integer.BYTES, action[at % action.length]);
    }
    worlds.step();
  }

  ByteBuffer part(String name) {
    return worlds.block().slice(worlds.memory(), name);
  }

  /** What one world has in a section. */
  byte[] bytes(String name, int world) {
    ByteBuffer all = part(name);
    byte[] one = new byte[all.capacity() / count];
    all.get(world * one.length, one);
    return one;
  }

  float[] floats(String name, int world) {
    ByteBuffer bytes = ByteBuffer.wrap(bytes(name, world)).order(ByteOrder.nativeOrder());
    float[] numbers = new float[bytes.capacity() / Float.BYTES];
    bytes.asFloatBuffer().get(numbers);
    return numbers;
  }

  /** A number for all that one world has. */
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
