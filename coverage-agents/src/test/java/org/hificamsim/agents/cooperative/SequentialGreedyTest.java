package org.hificamsim.agents.cooperative;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;

/** Compares agreed plans of a few cameras, with a submodular worth, with the best of all plans. */
class SequentialGreedyTest {
  private static final int CAMERAS = 4;
  private static final int VIEWS = 5;
  private static final int TARGETS = 8;
  private static final Parameters PARAMETERS =
      Parameters.from(Options.parse("cooperative", "search=0,hold=0"));

  /** Each view of a camera detects random targets, or random ones of the camera's own targets. */
  private static final class RandomSets extends ToyNetwork {
    private final boolean[][][] seen = new boolean[CAMERAS][VIEWS][TARGETS];

    RandomSets(int seed, boolean disjoint) {
      super(TARGETS, VIEWS, VIEWS, VIEWS, VIEWS);
      scoredBy(Objective.parse("covered:k=1"));
      SplittableRandom random = new SplittableRandom(seed);
      for (int camera = 0; camera < CAMERAS; camera++) {
        for (boolean[] targets : seen[camera]) {
          for (int target = 0; target < TARGETS; target++) {
            boolean own = !disjoint || target % CAMERAS == camera;
            targets[target] = own && random.nextInt(3) == 0;
          }
        }
      }
    }

    /** The x coordinate of a target is its number. */
    @Override
    public boolean chancesAt(
        int camera, double x, double y, double size, double transmittance, double[] chances) {
      for (int view = 0; view < VIEWS; view++) {
        chances[view] = x == Math.rint(x) && seen[camera][view][(int) x] ? 1 : 0;
      }
      return true;
    }
  }

  @Test
  void reachesAtLeastHalfOfTheBestPlan() {
    for (int seed = 0; seed < 200; seed++) {
      RandomSets network = new RandomSets(seed, false);
      double best = best(network, plan(network), 0, 0);
      assertTrue(
          agreed(network, SequentialGreedyTest::chooseInTurn) >= best / 2 - 1e-9,
          "seed " + seed + ": " + best);
    }
  }

  @Test
  void findsTheBestPlanWhenCamerasShareNoTargets() {
    for (int seed = 0; seed < 200; seed++) {
      RandomSets network = new RandomSets(seed, true);
      double best = best(network, plan(network), 0, 0);
      assertTrue(best > 0, "nothing to see");
      assertEquals(best, agreed(network, SequentialGreedyTest::chooseInTurn), 1e-9, "seed " + seed);
      assertEquals(best, agreed(network, new MaxSum(PARAMETERS, network)), 1e-9, "seed " + seed);
    }
  }

  private static void chooseInTurn(NetworkView network, Team team) {
    Agreement.chooseInTurn(network, team, 5);
  }

  /** Cycles in the graph cost something, but not much. */
  @Test
  void maxSumComesCloseToTheBestPlanOnAverage() {
    double best = 0;
    double reached = 0;
    for (int seed = 0; seed < 200; seed++) {
      RandomSets network = new RandomSets(seed, false);
      best += best(network, plan(network), 0, 0);
      reached += agreed(network, new MaxSum(PARAMETERS, network));
    }
    assertTrue(reached > 0.9 * best, reached + " of " + best);
  }

  /** The worth of the plan that cameras agree on: the sum of what each adds to those before it. */
  private static double agreed(RandomSets network, Agreement agreement) {
    Team team = new Team(PARAMETERS, site(network), network, false);
    SightingReport[] reports = new SightingReport[network.cameras()];
    for (int camera = 0; camera < reports.length; camera++) {
      reports[camera] = new SightingReport(true);
      reports[camera].begin(network, camera);
    }
    team.share(network, reports);
    seeAll(network, team.mind(0).belief());
    team.plan(0).begin(network, team.mind(0).belief());
    agreement.agree(network, team);
    Plan plan = plan(network);
    double worth = 0;
    for (int camera = 0; camera < network.cameras(); camera++) {
      worth += plan.gains(network, camera)[team.chosenView(camera)];
      plan.choose(camera, plan.wayTo(network, camera, team.chosenView(camera)));
    }
    return worth;
  }

  /** The greatest worth of plans that extend the views of the cameras before {@code camera}. */
  private static double best(RandomSets network, Plan plan, int camera, double before) {
    double greatest = before;
    for (int view = 0; camera < network.cameras() && view < network.views(camera); view++) {
      double added = plan.gains(network, camera)[view];
      plan.choose(camera, plan.wayTo(network, camera, view));
      greatest = Math.max(greatest, best(network, plan, camera + 1, before + added));
      plan.withdraw(camera);
    }
    return greatest;
  }

  private static Plan plan(RandomSets network) {
    Worth worth = new Worth(network.objective(), PARAMETERS.lead(), PARAMETERS.further());
    Belief belief = new Belief(PARAMETERS, worth, site(network), network);
    seeAll(network, belief);
    Plan plan = new Plan(PARAMETERS, worth, network.cameras());
    plan.begin(network, belief);
    return plan;
  }

  private static Site site(RandomSets network) {
    Site site = new Site(network, network.obstacles(), 20);
    site.refresh(network);
    return site;
  }

  private static void seeAll(RandomSets network, Belief belief) {
    for (int target = 0; target < network.targets(); target++) {
      belief.tracks().see(Sightings.at(0, target, target, 0), 0, 0);
    }
  }
}
