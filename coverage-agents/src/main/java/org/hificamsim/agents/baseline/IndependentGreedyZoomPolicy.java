package org.hificamsim.agents.baseline;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.agents.choice.PanAngles;
import org.hificamsim.core.policy.OraclePolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.registry.Options;

/**
 * Each camera takes the view in which it would detect most targets now, whatever the others detect;
 * by chance, the view in which it is expected to detect most. It knows what no camera knows, what
 * it would detect in other views, but not the luck that is drawn.
 *
 * <p>It chooses among the views that it {@linkplain OracleView#reaches reaches}; where it would
 * detect nothing in any of these, it sets out for the best view of all, however far. Of equally
 * good views it takes the one it is in, then the widest, then the one that it turns least for.
 *
 * <p>It is not the greedy approach of thesis 7.4.1, which is {@code optimal} or {@code one-hop}.
 */
public final class IndependentGreedyZoomPolicy implements OraclePolicy {
  /** Which views a camera chooses among. */
  private enum Among {
    REACHED,
    ALL
  }

  private final Among among;
  private double[] expected = {}; // number of targets, by view
  private int[] targets = {};
  private double[] chances = {};
  private long[] masks = {};
  private int words;

  /** Reads the option {@code among}. */
  public IndependentGreedyZoomPolicy(Options options) {
    among =
        options.choice(
            "among",
            Among.REACHED,
            "reached: views that a camera can be in by the end of the step; all: any view");
  }

  @Override
  public String name() {
    return "independent-greedy";
  }

  @Override
  public void begin(OracleView network, SplittableRandom random) {
    expected =
        new double[IntStream.range(0, network.cameras()).map(network::views).max().orElse(0)];
    words = (network.targets() + Long.SIZE - 1) / Long.SIZE;
    masks = new long[expected.length * words];
    targets = new int[network.targets() + 1];
    chances = new double[network.targets() + 1];
  }

  @Override
  public void decide(OracleView network, int[] views) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        views[camera] = choose(network, camera);
      }
    }
  }

  private int choose(OracleView network, int camera) {
    expect(network, camera);
    int reached = among == Among.REACHED ? best(network, camera, false) : network.view(camera);
    return among == Among.ALL || expected[reached] == 0 ? best(network, camera, true) : reached;
  }

  /** Without luck, all views are asked at once. */
  private void expect(OracleView network, int camera) {
    if (network.certain()) {
      network.detections(camera, masks, words);
    }
    for (int view = 0; view < network.views(camera); view++) {
      expected[view] = network.certain() ? count(view) : expected(network, camera, view);
    }
  }

  private int count(int view) {
    int count = 0;
    for (int word = view * words; word < (view + 1) * words; word++) {
      count += Long.bitCount(masks[word]);
    }
    return count;
  }

  private double expected(OracleView network, int camera, int view) {
    int count = network.chances(camera, view, targets, chances);
    double sum = 0;
    for (int i = 0; i < count; i++) {
      sum += chances[i];
    }
    return sum;
  }

  private int best(OracleView network, int camera, boolean any) {
    int best = network.view(camera);
    double most = any || network.reaches(camera, best) ? expected[best] : 0;
    for (int view = 0; view < network.views(camera); view++) {
      boolean better =
          expected[view] > most
              || (expected[view] == most && isPreferred(network, camera, view, best));
      if (better && (any || network.reaches(camera, view))) {
        best = view;
        most = expected[view];
      }
    }
    return best;
  }

  /** Whether a view is better than another one in which as much is detected. */
  private static boolean isPreferred(OracleView network, int camera, int view, int other) {
    int current = network.view(camera);
    if (other == current) {
      return false;
    }
    int wider = network.zoomOf(camera, view) - network.zoomOf(camera, other);
    return wider > 0
        || (wider == 0
            && turn(network, camera, view, current) < turn(network, camera, other, current));
  }

  private static double turn(OracleView network, int camera, int view, int from) {
    return PanAngles.off(network, camera, network.panOf(camera, view), network.pan(camera, from));
  }
}
