package org.hificamsim.agents.baseline;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.agents.choice.PanAngles;
import org.hificamsim.core.policy.OraclePolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.registry.Options;
import org.hificamsim.solver.BitMatrix;

/**
 * Each camera takes the view in which it would detect most targets now, and ignores what others
 * detect. If detections depend on chance, it takes the view with the greatest expected number. It
 * uses what no camera knows, what it would detect in other views, but not the luck that will be
 * drawn.
 *
 * <p>A camera chooses among the views that it {@linkplain OracleView#reaches reaches}. If it would
 * detect nothing in any of these, it moves towards the best of all views, however far. Among
 * equally good views it prefers the present one, then the widest, then the one for which it turns
 * least.
 *
 * <p>This is not the greedy approach of thesis 7.4.1, which is {@code optimal} or {@code one-hop}.
 */
public final class IndependentGreedyZoomPolicy implements OraclePolicy {
  /** The views among which a camera chooses. */
  private enum Among {
    REACHED,
    ALL
  }

  private final Among among;

  /** The expected number of detected targets, by view. */
  private double[] expected = {};

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
    words = BitMatrix.wordsFor(network.targets());
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
    updateExpected(network, camera);
    int reached = among == Among.REACHED ? best(network, camera, false) : network.view(camera);
    return among == Among.ALL || expected[reached] == 0 ? best(network, camera, true) : reached;
  }

  /** Computes the expected numbers of a camera, for all views at once if no chance is involved. */
  private void updateExpected(OracleView network, int camera) {
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

  private int best(OracleView network, int camera, boolean unreached) {
    int best = network.view(camera);
    double greatest = unreached || network.reaches(camera, best) ? expected[best] : 0;
    for (int view = 0; view < network.views(camera); view++) {
      boolean better =
          expected[view] > greatest
              || (expected[view] == greatest && isPreferred(network, camera, view, best));
      if (better && (unreached || network.reaches(camera, view))) {
        best = view;
        greatest = expected[view];
      }
    }
    return best;
  }

  /** Whether a view is preferred to another one in which as many targets are detected. */
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
    return PanAngles.difference(
        network, camera, network.panOf(camera, view), network.pan(camera, from));
  }
}
