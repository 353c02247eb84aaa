package org.hificamsim.bench;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.worlds.ActionKind;
import org.hificamsim.worlds.Block;
import org.hificamsim.worlds.Rewards;
import org.hificamsim.worlds.WorldSettings;
import org.hificamsim.worlds.Worlds;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures the microseconds per step of one world among {@value #WORLDS}, on one thread. Actions
 * are random; observations and rewards are computed, and episodes of 1,000 steps follow each other.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(2)
public class WorldsBenchmark {
  private static final int WORLDS = 256;
  private static final int EPISODE = 1_000;

  @Param({"bench/cluster-8", "scenarios/mate-4v8-9", "scenarios/junction"})
  private String scenario;

  @Param({"hifi:orb-lin"})
  private String detection;

  @Param({"coverage"})
  private String reward;

  private Worlds worlds;
  private ByteBuffer actions;
  private final SplittableRandom random = new SplittableRandom(1);
  private int choices;

  /** Reads the scenario and makes the worlds. */
  @Setup
  public void start() {
    Catalogue catalogue = Catalogue.load();
    Scenario read =
        ScenarioReader.read(
            Path.of(scenario + ".xml"), catalogue.movements()::knows, warning -> {});
    WorldSettings settings =
        new WorldSettings(
            read,
            null,
            catalogue.movements(),
            Detection.of(catalogue.detection(detection)),
            ObservationLayout.DEFAULT,
            ActionKind.VIEW,
            () -> Rewards.registry().create(reward),
            EPISODE,
            WorldSettings.AutoReset.SAME_STEP,
            null);
    worlds = new Worlds(settings, WORLDS, 1, 0, ByteBuffer::allocateDirect);
    Block.Section section = worlds.block().sections().get(0);
    actions = worlds.memory().slice(section.offset(), section.bytes());
    actions.order(ByteOrder.nativeOrder());
    choices = worlds.choices().get(0);
  }

  /** Makes one step of every world. */
  @Benchmark
  @OperationsPerInvocation(WORLDS)
  public void step() {
    for (int offset = 0; offset < actions.capacity(); offset += Integer.BYTES) {
      actions.putInt(offset, random.nextInt(choices));
    }
    worlds.step();
  }

  /** Ends the worlds. */
  @TearDown
  public void end() {
    worlds.close();
  }
}
