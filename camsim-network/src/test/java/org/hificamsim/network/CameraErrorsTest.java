package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.hificamsim.network.NetworkSettings.GraphUse;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.HistoricalParameters;
import org.hificamsim.network.agent.MessageKind;
import org.hificamsim.network.agent.MessageQueue;
import org.hificamsim.network.agent.Searches;
import org.hificamsim.network.agent.Sightings;
import org.hificamsim.network.agent.TargetKeys;
import org.hificamsim.network.bandit.BanditParameters;
import org.junit.jupiter.api.Test;

/** Tests random failures with scripted draws: percent, camera, duration, in percent. */
class CameraErrorsTest {
  private static final int ERROR_LEVEL = 4;
  private static final int RESET_LEVEL = 50;
  private static final int NO_FAILURE = ERROR_LEVEL + 1;

  private final World world = new TestScenario().camera(0, 0).camera(2, 0).target(1, 0).world();
  private final Agent[] agents = new Agent[2];

  /** Returns given numbers, each of which must be below the requested bound. */
  private static final class Script extends Random {
    private static final long serialVersionUID = 1L;
    private final int[] numbers;
    private int next;

    Script(int... numbers) {
      this.numbers = numbers;
    }

    @Override
    public int nextInt(int bound) {
      assertTrue(numbers[next] < bound, numbers[next] + " of " + bound);
      return numbers[next++];
    }
  }

  private CameraErrors errors(Script script, Quirk... quirks) {
    EnumSet<Quirk> chosen = EnumSet.noneOf(Quirk.class);
    chosen.addAll(List.of(quirks));
    NetworkSettings settings =
        new NetworkSettings(
            List.of(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            GraphUse.AS_IN_FILE,
            ERROR_LEVEL,
            RESET_LEVEL,
            BanditParameters.DEFAULT,
            HistoricalParameters.DEFAULT,
            chosen);
    makeAgents(settings);
    return new CameraErrors(world, settings, script);
  }

  private void makeAgents(NetworkSettings settings) {
    Detection detection = Detection.of(new CamSimVisibilityDetection());
    Sightings sightings = new Sightings(world, Visibility.asInCamSim(detection, 0));
    Agent.Shared shared =
        new Agent.Shared(
            world.cameras(),
            new TargetKeys(new double[] {1}),
            sightings,
            new Searches(world.cameras(), world.targets().count()),
            new MessageQueue(4, 8),
            new Random(0),
            null,
            false);
    AgentFactory factory = new AgentFactory(world, settings, new Random(0));
    for (int camera = 0; camera < agents.length; camera++) {
      agents[camera] = factory.agent(camera, shared);
      agents[camera].addNeighbour(1 - camera);
    }
  }

  /** Runs some steps; returns 1 or 0 for each, depending on whether camera 0 is online. */
  private String online(CameraErrors errors, int steps) {
    StringBuilder online = new StringBuilder();
    for (int step = 0; step < steps; step++) {
      errors.step(agents, agents.length);
      online.append(world.cameras().online(0) ? 1 : 0);
    }
    return online.toString();
  }

  /** Returns the number of neighbours that camera 0 asks when it advertises a target. */
  private int asked() {
    agents[0].receive(MessageKind.START_TRACKING, 1, 0, 0);
    agents[0].advertise();
    return agents[0].attempts();
  }

  @Test
  void drawsOnceIfDrawExceedsLevel() {
    Script script = new Script(NO_FAILURE, 99);
    assertEquals("11", online(errors(script), 2));
    assertEquals(2, script.next);
  }

  @Test
  void drawAtLevelFailsCameraForDrawnSteps() {
    Script script = new Script(ERROR_LEVEL, 0, 3, 0, 99, 99, 99, 99);
    assertEquals("00011", online(errors(script), 5));
    assertTrue(world.cameras().online(1));
  }

  @Test
  void failedCameraStaysOfflineUnderQuirk() {
    Script script = new Script(0, 0, 1, 0, 99, 99, 99);
    assertEquals("0000", online(errors(script, Quirk.FAILED_CAMERAS_STAY_OFFLINE), 4));
  }

  @Test
  void durationOfZeroBringsTemporarilyFailedCameraBack() {
    Script script = new Script(0, 0, 9, 0, 0, 0, 0, 0, 99);
    assertEquals("011", online(errors(script, Quirk.FAILED_CAMERAS_STAY_OFFLINE), 3));
  }

  @Test
  void cameraSwitchedOffForEverStaysOffline() {
    Script script = new Script(0, 0, 0, 0, 99, 0, 0, 2, 0, 99, 99);
    CameraErrors errors = errors(script);
    world.switchCamera(0, false);
    errors.switchedOff(0, -1);
    errors.switchedOff(0, 1);
    assertEquals("00000", online(errors, 5));
  }

  @Test
  void cameraSwitchedOffForSomeStepsComesBack() {
    CameraErrors errors = errors(new Script(99, 99, 99, 99));
    world.switchCamera(0, false);
    errors.switchedOff(0, 2);
    assertEquals("0011", online(errors, 4));
  }

  @Test
  void failingCameraForgetsNeighboursOnlyAboveResetLevel() {
    online(errors(new Script(0, 0, 0, RESET_LEVEL)), 1);
    assertEquals(1, asked());
    online(errors(new Script(0, 0, 0, RESET_LEVEL + 1)), 1);
    assertEquals(0, asked());
  }

  @Test
  void nothingFailsBeforeFirstCameraIsAdded() {
    Script script = new Script(0);
    errors(script).step(agents, 0);
    assertEquals(1, script.next);
  }

  @Test
  void drawsNothingBelowLevelZero() {
    new CameraErrors(world, NetworkSettings.CAMSIM, new Script()).step(agents, agents.length);
    assertTrue(world.cameras().online(0) && world.cameras().online(1));
  }

  @Test
  void neverDrawsCameraThatIsNotAddedYet() {
    CameraErrors errors = errors(new Script(0, 0, 1, 0));
    errors.step(agents, 1);
    assertFalse(world.cameras().online(0));
  }
}
