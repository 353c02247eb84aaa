package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.network.RoleReader.CameraRole;
import org.hificamsim.network.agent.CommunicationPolicy;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.bandit.BanditAlgorithm;
import org.junit.jupiter.api.Test;

/** Tests roles from the attributes of cameras, and from settings for all cameras. */
class RoleReaderTest {
  private static final CameraSpec NOTHING = new CameraSpec("a", 0, 0, 5);
  private static final CameraSpec SMOOTH =
      spec("PassiveAuctionSchedule", 1, null, "epics.learning.UCB1");

  private static CameraSpec spec(String algorithm, int comm, String customComm, String bandit) {
    return NOTHING
        .with(CameraSpec.ALGORITHM, algorithm)
        .with(CameraSpec.COMM, comm)
        .with(CameraSpec.CUSTOM_COMM, Optional.ofNullable(customComm))
        .with(CameraSpec.LIMIT, 7)
        .with(CameraSpec.BANDIT, Optional.ofNullable(bandit));
  }

  private static CameraRole read(RoleReader reader, CameraSpec camera, boolean added) {
    return reader.read(
        camera, added, (attribute, expected) -> new InputException(attribute + ": " + expected));
  }

  private static String fault(CameraSpec camera) {
    RoleReader reader = new RoleReader(NetworkSettings.CAMSIM, false);
    return assertThrows(InputException.class, () -> read(reader, camera, false)).getMessage();
  }

  @Test
  void eachCameraOfFileGetsItsOwnRole() {
    CameraRole role = read(new RoleReader(NetworkSettings.CAMSIM, false), SMOOTH, false);
    assertEquals(ScheduleKind.PASSIVE, role.schedule());
    assertEquals(CommunicationPolicy.SMOOTH, role.communication().policy());
    assertEquals(7, role.limit());
    assertEquals(Optional.of(BanditAlgorithm.UCB1), role.bandit());
  }

  @Test
  void settingsApplyToAllCamerasOfFile() {
    NetworkSettings all = NetworkSettings.CAMSIM.withStrategies(Strategy.parse("HA3"));
    CameraRole role = read(new RoleReader(all, false), SMOOTH, false);
    assertEquals(ScheduleKind.HISTORICAL_ACTIVE, role.schedule());
    assertTrue(role.communication().isFix());
  }

  @Test
  void addedCameraTakesLastScheduleOfFileAndItsOwnPolicy() {
    NetworkSettings all = NetworkSettings.CAMSIM.withStrategies(Strategy.parse("HP3"));
    RoleReader reader = new RoleReader(all, false);
    read(reader, NOTHING, false);
    CameraRole role = read(reader, spec("Nobody", 2, null, null), true);
    assertEquals(ScheduleKind.HISTORICAL_PASSIVE, role.schedule());
    assertEquals(CommunicationPolicy.STEP, role.communication().policy());
  }

  @Test
  void onlyFixByNumberOrOldNameFreezesLinks() {
    assertTrue(communication(3, null).freezesLinks());
    assertTrue(communication(4, "epics.commpolicy.Fix").freezesLinks());
    assertFalse(communication(4, "epics.ai.commpolicy.Fix").freezesLinks());
    assertFalse(communication(0, null).freezesLinks());
    assertTrue(communication(3, null).isFix());
    assertFalse(communication(4, "Fix").isFix());
  }

  private static CommunicationSetting communication(int number, String name) {
    return CommunicationSetting.of(number, Optional.ofNullable(name)).orElseThrow();
  }

  @Test
  void faultsForUnknownOrMissingValuesNameAttribute() {
    assertTrue(fault(spec("Nobody", 0, null, null)).startsWith("ai_algorithm: one of Active, "));
    assertTrue(fault(spec("Active", 4, "Nobody", null)).startsWith("customcom: one of Broadcast"));
    assertTrue(fault(spec("Active", 4, null, null)).endsWith(" where comm is 4"));
    assertTrue(fault(spec("Active", 0, null, "Nobody")).startsWith("bandit: one of EpsilonG"));
    assertTrue(fault(spec("BanditZoom", 0, null, null)).endsWith("schedule is BanditZoom"));
  }

  @Test
  void rejectsZoomListWithZoomBandit() {
    CameraSpec zooming = spec("BanditZoom", 0, null, "UCB1");
    CameraRole role = read(new RoleReader(NetworkSettings.CAMSIM, false), zooming, false);
    assertEquals(ScheduleKind.BANDIT_ZOOM, role.schedule());
    RoleReader reader = new RoleReader(NetworkSettings.CAMSIM, true);
    InputException error = assertThrows(InputException.class, () -> read(reader, zooming, false));
    assertTrue(error.getMessage().startsWith("zoom: none, or no policy, "), error::getMessage);
  }
}
