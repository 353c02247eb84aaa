package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumSet;
import org.hificamsim.core.InputException;
import org.hificamsim.network.agent.Named;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.bandit.BanditAlgorithm;
import org.hificamsim.network.statistics.StepFigures;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests ownership, auctions, messages and schedules in scenarios that are small enough to check by
 * hand.
 */
class NetworkTest {
  private static final String ACTIVE = "ai_algorithm='active' comm='0'";
  private static final String PASSIVE = "ai_algorithm='passive' comm='0'";

  @Test
  void firstCameraToSeeNewTargetOwnsIt() {
    SmallNetwork network = pair(ACTIVE, ACTIVE).run(1);
    assertEquals("A", network.owners("1.0"));
    assertEquals(0, network.last().handovers());
  }

  @Test
  void cameraThatSeesBetterBuysTargetInNextStep() {
    SmallNetwork network = pair(ACTIVE, ACTIVE).run(2);
    assertEquals("B", network.owners("1.0"));
    assertEquals(1, network.last().handovers());
    assertEquals(1, network.last().communication());
  }

  @Test
  void passiveOwnerKeepsTargetInSteadyView() {
    SmallNetwork network = pair(PASSIVE, PASSIVE).run(20);
    assertEquals("A", network.owners("1.0"));
    assertEquals(0, network.last().communication());
  }

  @Test
  void targetHandedToEarlierCameraCountsInUtilityOnly() {
    SmallNetwork network =
        new SmallNetwork()
            .camera("A", 9, 0, 3, ACTIVE)
            .camera("B", 0, 0, 10, ACTIVE)
            .target("features='1' x='4.7' y='0' heading='90' speed='1'")
            .run(2);
    assertEquals("A", network.owners("1.0"));
    assertEquals(0, network.last().proportion());
    assertTrue(network.last().utility() > 0);
    assertEquals(1, network.run(1).last().proportion());
  }

  private static SmallNetwork pair(String first, String second) {
    return new SmallNetwork()
        .camera("A", 0, 0, 10, first)
        .camera("B", 8, 0, 10, second)
        .still("1", 6, 0);
  }

  @Test
  void limitRestrictsClaimsButNotAuctions() {
    SmallNetwork network =
        new SmallNetwork()
            .camera("A", 0, 0, 10, ACTIVE + " limit='1'")
            .still("1", 1, 0)
            .still("2", 0, 1)
            .run(5);
    assertEquals("A", network.owners("1.0"));
    assertEquals("", network.owners("2.0"));
  }

  @Test
  void fixPolicyWithoutGraphSendsNothing() {
    SmallNetwork network = pair("comm='3'", "comm='3'").run(20);
    assertEquals(0, network.last().communication());
    assertEquals("A", network.owners("1.0"));
  }

  @Test
  void cameraDefaultsToActiveAndBroadcast() {
    assertEquals("B", pair("", "").run(2).owners("1.0"));
  }

  @ParameterizedTest
  @CsvSource({
    "epics.ai.ActiveAINodeMulti, ACTIVE",
    "epics.ai.auctionSchedules.ActiveAuctionSchedule, ACTIVE",
    "ActiveAuctionSchedule, ACTIVE",
    "active, ACTIVE",
    "PASSIVE, PASSIVE",
    "epics.ai.PassiveAINodeMulti, PASSIVE",
    "epics.ai.HistoricalUnweightedAINodeMulti, HISTORICAL_ACTIVE",
    "epics.ai.HistoricalAINode$Passive, HISTORICAL_PASSIVE",
    "HistoricalAINode.Active, HISTORICAL_ACTIVE",
    "epics.ai.dynamicZoom.NewActiveBCBanditRange, BANDIT_ZOOM",
    "BanditSolverZoom, BANDIT_ZOOM",
  })
  void acceptsOldNewAndShortNamesOfSchedules(String name, ScheduleKind kind) {
    assertEquals(kind, Named.find(ScheduleKind.class, name).orElseThrow());
  }

  @Test
  void findsEveryKindByEachOfItsNames() {
    for (ScheduleKind kind : EnumSet.allOf(ScheduleKind.class)) {
      kind.names()
          .forEach(name -> assertEquals(kind, Named.find(ScheduleKind.class, name).orElseThrow()));
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "ai_algorithm='epics.ai.Nobody'",
        "comm='4'",
        "comm='4' customcom='Whisper'",
        "bandit='Gambler'",
        "ai_algorithm='BanditZoom'",
      })
  void errorsForUnknownOrMissingValuesNameCamera(String attributes) {
    SmallNetwork network = pair(attributes, ACTIVE);
    InputException error = assertThrows(InputException.class, () -> network.run(1));
    assertTrue(error.getMessage().startsWith("camera 'A'"), error.getMessage());
  }

  @ParameterizedTest
  @EnumSource(BanditAlgorithm.class)
  void everyBanditSwitchesSchedulesAndIsCounted(BanditAlgorithm bandit) {
    SmallNetwork network = pair(ACTIVE, PASSIVE).bandit(bandit).run(100);
    int changes = 0;
    double utility = 0;
    for (int step = 0; step < 100; step++) {
      changes += network.row(step).strategyChanges();
      utility += network.row(step).banditUtility();
    }
    assertTrue(changes > 10, changes + " changes");
    assertTrue(utility > 0, utility + " utility");
  }

  @ParameterizedTest
  @EnumSource(BanditAlgorithm.class)
  void everyBanditChangesTheRange(BanditAlgorithm bandit) {
    SmallNetwork network =
        pair("ai_algorithm='BanditZoom'", "ai_algorithm='BanditZoom'").bandit(bandit).run(200);
    StepFigures last = network.last();
    assertEquals(0, last.strategyChanges());
    assertEquals(0, last.banditUtility());
    double range = network.world().cameras().zoom(0, 0).radius();
    assertTrue(range > 0 && range < 20 && range != 10, range + " m");
  }

  @Test
  void runsThousandsOfSteps() {
    SmallNetwork network = pair("comm='1'", "comm='2'").bandit(BanditAlgorithm.UCB_TUNED).run(2000);
    assertEquals(1999, network.last().step());
  }
}
