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

/** Compares the choices of a linear layer with those computed by hand. */
class OnnxPolicyTest {
  private static final int STEPS = 300;

  @Test
  void choosesTheCamerasViewOfHighestValue() {
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
  void stepsFromTheCurrentViewUsingTheFilesLayout() {
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

  private static void run(ZoomPolicy policy) {
    Catalogue catalogue = Catalogue.load();
    Path file = Path.of(System.getProperty("hificamsim.root"), "scenarios", "corridor.xml");
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
    private final OnnxPolicy policy;
    private final ObservationLayout layout;
    private final int width;
    private CameraObserver observer;
    int decisions;
    int moves;

    ExpectedChoices(String name, ObservationLayout layout, int width) {
      this.layout = layout;
      this.width = width;
      policy = (OnnxPolicy) Catalogue.load().policies().create("onnx:" + Shipped.file(name));
    }

    abstract int expected(NetworkView network, int camera, float[] observation);

    @Override
    public String name() {
      return "by-hand";
    }

    @Override
    public void begin(NetworkView network, SplittableRandom random) {
      policy.begin(network, random);
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
        boolean free = !network.moving(camera);
        int expected = free ? expected(network, camera, observation) : network.view(camera);
        assertEquals(expected, views[camera], "camera " + camera + " at step " + network.step());
        decisions += free ? 1 : 0;
        moves += views[camera] != network.view(camera) ? 1 : 0;
      }
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
