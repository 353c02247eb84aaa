package org.hificamsim.onnx;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.agents.observation.CameraObserver;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares the choices of a linear layer with those computed by hand. */
class OnnxPolicyTest {
  private static final int STEPS = 300;

  @Test
  void choosesViewOfHighestValue() {
    ExpectedChoices views =
        new ExpectedChoices("linear.onnx", ObservationLayout.DEFAULT, 65) {
          @Override
          int expected(NetworkView network, int camera, float[] observation) {
            return best(observation, 0, network.views(camera), view -> true);
          }
        };
    run(views);
    assertTrue(views.decisions > STEPS, views.decisions + " decisions");
    assertTrue(views.moves > 50, views.moves + " moves");
  }

  @Test
  void stepsFromCurrentViewByLayoutOfFile() {
    ExpectedChoices steps =
        new ExpectedChoices("steps.onnx", new ObservationLayout(3, 1, false), 6) {
          @Override
          int expected(NetworkView network, int camera, float[] observation) {
            int zooms = network.zooms(camera);
            int pans = network.views(camera) / zooms;
            int pan = network.view(camera) / zooms;
            int zoom = network.view(camera) % zooms;
            int turn =
                best(observation, 0, 3, step -> pan + step - 1 >= 0 && pan + step - 1 < pans);
            int lens =
                best(observation, 3, 3, step -> zoom + step - 1 >= 0 && zoom + step - 1 < zooms);
            return (pan + turn - 1) * zooms + zoom + lens - 1;
          }
        };
    run(steps);
    assertTrue(steps.decisions > 100, steps.decisions + " decisions");
    assertTrue(steps.moves > 0, "no camera moved");
  }

  /** The belief of each view is valued by the same numbers on any site. */
  @ParameterizedTest
  @ValueSource(strings = {"corridor", "junction", "campus-heights"})
  void valuesViewsBySharedBeliefOnAnySite(String site) {
    ExpectedChoices greedy =
        new ExpectedChoices("views.onnx", new ObservationLayout(0, 0, false), 0) {
          @Override
          int expected(NetworkView network, int camera, float[] observation) {
            int first = observation.length - layout.views() * ObservationLayout.viewSize();
            int best = 0;
            for (int view = 0; view < network.views(camera); view++) {
              best =
                  value(observation, first, view) > value(observation, first, best) ? view : best;
            }
            return best;
          }

          private float value(float[] observation, int first, int view) {
            int offset = first + view * ObservationLayout.viewSize();
            return observation[offset + 9] + observation[offset + 1] / 64;
          }
        };
    greedy.readsBelief();
    run(greedy, site);
    assertTrue(greedy.decisions > STEPS, greedy.decisions + " decisions");
    assertTrue(greedy.moves > 50, greedy.moves + " moves");
    assertTrue(greedy.policy.messages() > STEPS, greedy.policy.messages() + " messages");
  }

  @Test
  void remembersStateFromDecisionToDecision() {
    int[] episodes = new int[1];
    ExpectedChoices counting =
        new ExpectedChoices("memory.onnx", ObservationLayout.DEFAULT, 65) {
          @Override
          int expected(NetworkView network, int camera, float[] observation) {
            return (int) Math.min(network.step(), network.views(camera) - 1);
          }

          @Override
          public void begin(NetworkView network, SplittableRandom random) {
            super.begin(network, random);
            episodes[0]++;
          }
        };
    run(counting);
    run(counting);
    assertEquals(2, episodes[0]);
    assertTrue(counting.moves > 3, counting.moves + " moves");
  }

  private static void run(ZoomPolicy policy) {
    run(policy, "corridor");
  }

  private static void run(ZoomPolicy policy, String site) {
    Catalogue catalogue = Catalogue.load();
    Path file = Path.of(System.getProperty("hificamsim.root"), "scenarios", site + ".xml");
    Scenario scenario = ScenarioReader.read(file, catalogue.movements()::knows, warning -> {});
    Detection detection = new Detection(catalogue.detection("dori-2014:level=recognise"), 0.5);
    World world = new World(scenario, catalogue.movements(), 7);
    new Simulation(world, detection, policy, 7, List.of()).run(STEPS);
  }

  /** Decides which choices are allowed. */
  private interface ChoiceFilter {
    boolean test(int choice);
  }

  /** Runs the policy and checks each of its choices against a computed one. */
  private abstract static class ExpectedChoices implements ZoomPolicy {
    final OnnxPolicy policy;
    ObservationLayout layout;
    private final int width;
    private CameraObserver observer;
    private boolean readsBelief;
    int decisions;
    int moves;

    ExpectedChoices(String name, ObservationLayout layout, int width) {
      this.layout = layout;
      this.width = width;
      policy = (OnnxPolicy) Catalogue.load().policies().create("onnx:" + Shipped.file(name));
    }

    void readsBelief() {
      readsBelief = true;
    }

    abstract int expected(NetworkView network, int camera, float[] observation);

    @Override
    public String name() {
      return "by-hand";
    }

    @Override
    public void begin(NetworkView network, SplittableRandom random) {
      policy.begin(network, random);
      observer = null;
      if (readsBelief) {
        layout = layout.withBelief(network);
      }
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      observer = observer == null ? new CameraObserver(network, layout) : observer;
      float[] observations = new float[views.length * layout.size()];
      observer.observe(network, observations);
      policy.decide(network, views);
      for (int camera = 0; camera < views.length; camera++) {
        int start = camera * layout.size();
        float[] observation = Arrays.copyOfRange(observations, start, start + layout.size());
        boolean free = network.online(camera) && !network.moving(camera);
        int expected = free ? expected(network, camera, observation) : network.view(camera);
        assertEquals(expected, views[camera], "camera " + camera + " at step " + network.step());
        decisions += free ? 1 : 0;
        moves += views[camera] != network.view(camera) ? 1 : 0;
      }
      observer.learnChoices(network, views);
    }

    /** Returns the first allowed choice of the highest value; its values start at {@code from}. */
    int best(float[] observation, int from, int count, ChoiceFilter allowed) {
      int best = -1;
      for (int i = 0; i < count; i++) {
        boolean better = best < 0 || value(observation, from + i) > value(observation, from + best);
        best = allowed.test(i) && better ? i : best;
      }
      return best;
    }

    /** Computes output j of the layer in make_linear.py. */
    private double value(float[] observation, int j) {
      assertTrue(j < width);
      double sum = (j * 5 % 7 - 3) / 8.0;
      for (int i = 0; i < observation.length; i++) {
        sum += observation[i] * (((i * 7 + j * 13) % 31 - 15) / 16.0);
      }
      return sum;
    }
  }
}
