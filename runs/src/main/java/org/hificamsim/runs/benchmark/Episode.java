package org.hificamsim.runs.benchmark;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;

/**
 * A played episode.
 *
 * @param views for each step and camera, the view that the camera had chosen last
 * @param score the mean score of a step
 */
record Episode(int[][] views, double score) {
  /** Plays an episode. */
  static Episode play(Benchmark benchmark, RunPlan plan) {
    ZoomPolicy policy = benchmark.catalogue().policies().create(plan.policy());
    return play(benchmark, plan, policy);
  }

  private static Episode play(Benchmark benchmark, RunPlan plan, ZoomPolicy policy) {
    int[][] views = new int[plan.steps()][];
    StepListener recorder = (network, coverage) -> views[(int) network.step()] = views(network);
    RunExecutor executor = new RunExecutor(benchmark.catalogue());
    RunResult result = executor.repeat(plan, 0, policy, List.of(recorder));
    return new Episode(views, result.score() / plan.steps());
  }

  private static int[] views(NetworkView network) {
    int[] views = new int[network.cameras()];
    for (int camera = 0; camera < views.length; camera++) {
      views[camera] = network.view(camera);
    }
    return views;
  }

  /**
   * Plays an episode again with recorded views.
   *
   * @param where the name of the episode in errors
   * @throws InputException when a camera does not have its recorded view
   */
  static Episode replay(Benchmark benchmark, RunPlan plan, int[][] views, String where) {
    return play(
        benchmark,
        plan,
        new ZoomPolicy() {
          @Override
          public String name() {
            return "recorded";
          }

          @Override
          public void decide(NetworkView network, int[] next) {
            choose(network, views[(int) network.step()], next, where);
          }
        });
  }

  private static void choose(NetworkView network, int[] chosen, int[] next, String where) {
    for (int camera = 0; camera < next.length; camera++) {
      int most = network.views(camera) - 1;
      if (chosen[camera] < 0 || chosen[camera] > most) {
        throw InputException.of(
            "%s, step %s: camera %s has view %s, expected 0 to %s",
            where, network.step(), network.cameraName(camera), chosen[camera], most);
      }
      next[camera] = network.online(camera) ? chosen[camera] : next[camera];
    }
  }
}
