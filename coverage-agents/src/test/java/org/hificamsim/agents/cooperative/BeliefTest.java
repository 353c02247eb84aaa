package org.hificamsim.agents.cooperative;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;

/** Compares what is believed with exact inference over all paths that a target can have taken. */
class BeliefTest {
  private static final Grid GRID = new Grid(0, 0, 1, 4, 3);
  private static final double SPREAD = 0.4;
  private static final double FOUND_SHARE = 0.95;
  private static final Parameters PARAMETERS =
      Parameters.from(Options.parse("cooperative", "relax=0"));

  @Test
  void searchMapFollowsBayesRuleForAnUnseenTarget() {
    SearchMap map = map();
    LearnedSight nothingLearned = new LearnedSight(false, GRID, 1);
    double[] exact = new double[GRID.cells()];
    for (int cell = 0; cell < exact.length; cell++) {
      walk(cell, 0, 1.0 / exact.length, exact);
    }
    for (int step = 0; step < 5; step++) {
      map.look(cellsLookedAt(step), new float[] {0.6f, 0.9f, 0.25f}, nothingLearned, 0);
      map.step(SPREAD, 0);
    }
    assertEquals(1, Arrays.stream(map.unseenTargets()).sum() / Arrays.stream(exact).sum(), 1e-6);
    for (int cell = 0; cell < exact.length; cell++) {
      assertEquals(exact[cell], map.unseenTargets()[cell], 1e-8, "cell " + cell);
    }
  }

  private static SearchMap map() {
    boolean[] free = new boolean[GRID.cells()];
    Arrays.fill(free, true);
    return new SearchMap(PARAMETERS, GRID, free, 1);
  }

  private static int[] cellsLookedAt(int step) {
    return new int[] {step, 5, 11 - step};
  }

  /** Adds the chance of each path of five steps on which no camera sees the target. */
  private static void walk(int cell, int step, double chance, double[] exact) {
    if (step == 5) {
      exact[cell] += chance;
      return;
    }
    double stays = 1;
    for (int[] side : new int[][] {{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
      int column = cell % 4 + side[0];
      int row = cell / 4 + side[1];
      if (column >= 0 && column < 4 && row >= 0 && row < 3) {
        stays -= SPREAD / 4;
        stayUnseen(row * 4 + column, step, chance * SPREAD / 4, exact);
      }
    }
    stayUnseen(cell, step, chance * stays, exact);
  }

  private static void stayUnseen(int cell, int step, double chance, double[] exact) {
    float[] chances = {0.6f, 0.9f, 0.25f};
    double notSeen = 1;
    for (int i = 0; i < chances.length; i++) {
      notSeen *= cellsLookedAt(step)[i] == cell ? 1 - chances[i] : 1;
    }
    double stillUnseen = 1 - FOUND_SHARE * (1 - notSeen);
    walk(cell, step + 1, chance * stillUnseen, exact);
  }

  @Test
  void missedTargetLosesWeightByBayesRule() {
    TargetTracks tracks = new TargetTracks(PARAMETERS, Obstacles.NONE, 1);
    tracks.see(Sightings.at(0, 0, 3, 3), 0, 0);
    tracks.step();
    double there = tracks.weight(0);
    double thereAndMissed = there * (1 - 0.7);
    tracks.miss(0, 0.7);
    assertEquals(thereAndMissed / (thereAndMissed + 1 - there), tracks.weight(0), 1e-12);
    tracks.miss(0, 1);
    assertEquals(0, tracks.weight(0), 1e-12);
  }

  @Test
  void unseenTargetKeepsMovingUpToAWall() {
    Obstacles wall = new Obstacles(List.of(new Obstacle.Wall(5, 0, 5, 10, 0)));
    TargetTracks tracks = new TargetTracks(PARAMETERS, wall, 1);
    tracks.see(Sightings.at(0, 0, 1, 5), 0, 0);
    tracks.step();
    tracks.see(Sightings.at(1, 0, 2.5, 5), 0, 1);
    tracks.step();
    assertEquals(4, tracks.x(0), 1e-12);
    tracks.step();
    assertEquals(4, tracks.x(0), 1e-12);
  }

  @Test
  void lateReportIsExtrapolatedToThePresent() {
    TargetTracks tracks = new TargetTracks(PARAMETERS, Obstacles.NONE, 1);
    tracks.see(Sightings.at(0, 0, 1, 1), 0, 2);
    tracks.step();
    tracks.see(Sightings.at(1, 0, 1, 2), 0, 3);
    assertEquals(4, tracks.y(0), 1e-12);
    tracks.see(Sightings.at(0, 0, 9, 9), 0, 3);
    assertEquals(4, tracks.y(0), 1e-12);
  }
}
