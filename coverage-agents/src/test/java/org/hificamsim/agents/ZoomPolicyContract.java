package org.hificamsim.agents;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.util.Arrays;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.hificamsim.agents.toy.GeometricNetwork;
import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.policy.ZoomPolicy;
import org.junit.jupiter.api.DynamicTest;

/**
 * Tests of the contract between zoom policies and the engine, for built-in policies and users' own.
 *
 * @param policies makes a new instance for each run
 * @param global whether the policy is an upper bound that may use global knowledge
 */
public record ZoomPolicyContract(Supplier<ZoomPolicy> policies, boolean global) {
  private static final int STEPS = 300;
  private static final double UNTOUCHED = -12345;
  private static final GeometricNetwork.Kind MIXED =
      new GeometricNetwork.Kind(6, -5, 7, 2, false, true, 20, 15);

  /** The tests, each named after what it asserts. */
  public Stream<DynamicTest> tests() {
    return Stream.of(
        dynamicTest("hasTheSameNameInEveryInstance", this::hasTheSameNameInEveryInstance),
        dynamicTest("choosesViewsThatTheCameraHas", this::choosesViewsThatTheCameraHas),
        dynamicTest("choosesViewsThatTurningCamerasHave", this::choosesViewsThatTurningCamerasHave),
        dynamicTest(
            "toleratesCamerasAndTargetsThatComeAndGo",
            this::toleratesCamerasAndTargetsThatComeAndGo),
        dynamicTest("toleratesNetworksWithoutTargets", this::toleratesNetworksWithoutTargets),
        dynamicTest("toleratesNetworksWithoutCameras", this::toleratesNetworksWithoutCameras),
        dynamicTest("repeatsItselfForTheSameSeed", this::repeatsItselfForTheSameSeed),
        dynamicTest("sharesNoStateBetweenInstances", this::sharesNoStateBetweenInstances),
        dynamicTest("allocatesNothingPerStep", this::allocatesNothingPerStep),
        dynamicTest("knowsOnlyWhatItsCamerasKnow", this::knowsOnlyWhatItsCamerasKnow),
        dynamicTest("reportsConsistentEstimates", this::reportsConsistentEstimates),
        dynamicTest(
            "decidesTheSameWhenEstimatesAreRead", this::decidesTheSameWhenEstimatesAreRead));
  }

  private void hasTheSameNameInEveryInstance() {
    assertEquals(policies.get().name(), policies.get().name());
  }

  private void choosesViewsThatTheCameraHas() {
    for (int world = 0; world < 20; world++) {
      run(GeometricNetwork.random(MIXED, world), world, 50, false);
    }
  }

  /** Some cameras turn and some do not; moves take up to three steps. */
  private void choosesViewsThatTurningCamerasHave() {
    for (int world = 0; world < 20; world++) {
      run(GeometricNetwork.random(MIXED, world).turned(3, world % 3), world, 50, true);
    }
  }

  private void toleratesCamerasAndTargetsThatComeAndGo() {
    for (int world = 0; world < 20; world++) {
      run(GeometricNetwork.random(MIXED, world), world, 50, true);
    }
  }

  private void toleratesNetworksWithoutTargets() {
    run(
        GeometricNetwork.random(new GeometricNetwork.Kind(4, -5, 0, 1, false, false, 20, 15), 1),
        1,
        STEPS,
        true);
  }

  private void toleratesNetworksWithoutCameras() {
    run(
        GeometricNetwork.random(new GeometricNetwork.Kind(0, 5, 3, 1, false, false, 20, 15), 1),
        1,
        STEPS,
        true);
  }

  private void repeatsItselfForTheSameSeed() {
    int[][] first = run(GeometricNetwork.random(MIXED, 5), 11, STEPS, true);
    int[][] second = run(GeometricNetwork.random(MIXED, 5), 11, STEPS, true);
    assertEquals(STEPS, first.length);
    for (int step = 0; step < STEPS; step++) {
      assertArrayEquals(first[step], second[step], "step " + step);
    }
  }

  private void sharesNoStateBetweenInstances() {
    int[][] alone = run(GeometricNetwork.random(MIXED, 5), 11, STEPS, false);
    GeometricNetwork network = GeometricNetwork.random(MIXED, 5);
    GeometricNetwork other = GeometricNetwork.random(MIXED, 6);
    ZoomPolicy policy = network.begin(policies.get(), 11);
    ZoomPolicy otherPolicy = other.begin(policies.get(), 12);
    for (int step = 0; step < STEPS; step++) {
      other.step(otherPolicy);
      network.step(policy);
      assertArrayEquals(alone[step], network.currentViews(), "step " + step);
      network.scatter();
      other.scatter();
    }
  }

  private void allocatesNothingPerStep() {
    allocatesNothing(GeometricNetwork.random(MIXED, 3));
    allocatesNothing(GeometricNetwork.random(MIXED, 3).turned(3, 1));
  }

  private void allocatesNothing(GeometricNetwork network) {
    ZoomPolicy policy = network.begin(policies.get(), 1);
    allocatedBySteps(network, policy, 5_000);
    long bytes = AllocatedBytes.fewest(() -> allocatedBySteps(network, policy, 500));
    assertEquals(0, bytes, "bytes allocated in 500 steps");
  }

  private void knowsOnlyWhatItsCamerasKnow() {
    knowsOnlyWhatItsCamerasKnow(GeometricNetwork.random(MIXED, 8));
    knowsOnlyWhatItsCamerasKnow(GeometricNetwork.random(MIXED, 8).turned(3, 1));
  }

  private void knowsOnlyWhatItsCamerasKnow(GeometricNetwork network) {
    ZoomPolicy policy = network.begin(policies.get(), 1);
    for (int step = 0; step < STEPS; step++) {
      network.step(policy);
    }
    assertTrue(global || network.globalQueries() == 0, network.globalQueries() + " queries");
  }

  /**
   * A policy reports one name for all cameras and steps, a number or NaN for each view, and counts
   * of 0 or more; or it reports nothing.
   */
  private void reportsConsistentEstimates() {
    GeometricNetwork network = GeometricNetwork.random(MIXED, 8);
    ZoomPolicy policy = network.begin(policies.get(), 1);
    Set<String> names = new TreeSet<>();
    for (int step = 0; step < STEPS; step++) {
      network.step(policy);
      for (int camera = 0; camera < network.cameras(); camera++) {
        names.add(checkEstimates(network, policy, camera));
      }
      network.scatter();
      network.disturb();
    }
    assertEquals(1, names.size(), names.toString());
  }

  private static String checkEstimates(GeometricNetwork network, ZoomPolicy policy, int camera) {
    double[] estimates = new double[network.views(camera)];
    double[] counts = new double[network.views(camera)];
    Arrays.fill(estimates, UNTOUCHED);
    Arrays.fill(counts, UNTOUCHED);
    String name = policy.estimates(camera, estimates, counts);
    for (int view = 0; view < estimates.length; view++) {
      if (name.isEmpty()) {
        assertEquals(UNTOUCHED, estimates[view], "an estimate without a name");
      } else {
        assertNotEquals(UNTOUCHED, estimates[view], name + " of view " + view);
        assertFalse(Double.isInfinite(estimates[view]), name + " of view " + view);
        assertFalse(counts[view] < 0, name + " rests on " + counts[view]);
      }
    }
    return name;
  }

  private void decidesTheSameWhenEstimatesAreRead() {
    int[][] unseen = run(GeometricNetwork.random(MIXED, 5), 11, STEPS, false);
    GeometricNetwork network = GeometricNetwork.random(MIXED, 5);
    ZoomPolicy policy = network.begin(policies.get(), 11);
    for (int step = 0; step < STEPS; step++) {
      network.step(policy);
      assertArrayEquals(unseen[step], network.currentViews(), "step " + step);
      for (int camera = 0; camera < network.cameras(); camera++) {
        checkEstimates(network, policy, camera);
      }
      network.scatter();
    }
  }

  private static long allocatedBySteps(GeometricNetwork network, ZoomPolicy policy, int steps) {
    Runnable oneStep = () -> network.step(policy);
    long allocated = 0;
    for (int step = 0; step < steps; step++) {
      network.scatter();
      network.disturb();
      allocated += AllocatedBytes.by(oneStep);
    }
    return allocated;
  }

  /** Runs steps as the engine does, and checks each decision; returns the views after each step. */
  private int[][] run(GeometricNetwork network, long seed, int steps, boolean disturbed) {
    ZoomPolicy policy = policies.get();
    policy.begin(network, new SplittableRandom(seed));
    int[][] history = new int[steps][];
    for (int step = 0; step < steps; step++) {
      int[] before = network.currentViews();
      network.decide(policy);
      checkViews(network, before);
      network.observe();
      policy.learn(network);
      network.nextStep();
      history[step] = network.currentViews();
      network.scatter();
      if (disturbed) {
        network.disturb();
      }
    }
    return history;
  }

  private static void checkViews(GeometricNetwork network, int[] before) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      int view = network.view(camera);
      assertTrue(
          view >= 0 && view < network.views(camera),
          "camera " + camera + " view " + view + " after " + Arrays.toString(before));
    }
  }
}
