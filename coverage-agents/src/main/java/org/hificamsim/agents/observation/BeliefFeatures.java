package org.hificamsim.agents.observation;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.agents.cooperative.SharedBelief;
import org.hificamsim.agents.cooperative.ViewOutlook;
import org.hificamsim.core.policy.NetworkView;

/**
 * The numbers of an observation that say what each view of a camera promises, by the belief that
 * the cameras share: a row for each view, with zeros for views that a camera does not have.
 */
final class BeliefFeatures {
  private static final String COUNT = ", n / (n + 1) of n ";

  static final List<Feature> VIEW =
      List.of(
          Feature.share("exists", "1; 0 where the camera has no such view"),
          Feature.share("chosen", "1 for the view that it chose last"),
          Feature.share("seeing", "1 for the view that it sees through"),
          Feature.share("delay", "cost of the move" + COUNT + "steps until it sees through it"),
          Feature.share("targets", "known targets that it would detect" + COUNT + "in a step"),
          Feature.share("covered", "share of these that other cameras detect as well"),
          Feature.share("known", "worth of them beyond the others" + COUNT + "targets"),
          Feature.share("unseen", "targets expected in it that nobody sees" + COUNT + "targets"),
          Feature.share("gain", "what it adds if the others stay" + COUNT + "targets in a step"),
          Feature.share("gain_share", "the same over the greatest of the camera's views"));

  private final SharedBelief belief;
  private final int views;

  /**
   * @param views number of views in an observation
   */
  BeliefFeatures(NetworkView network, int views) {
    this.views = views;
    belief = new SharedBelief(network);
  }

  SharedBelief belief() {
    return belief;
  }

  /**
   * Updates the belief, and writes what the views of all cameras promise.
   *
   * @param first index of the first camera's first number
   * @param size length of a camera's observation
   */
  void write(NetworkView network, float[] out, int first, int size) {
    belief.update(network);
    for (int camera = 0; camera < network.cameras(); camera++) {
      int at = first + camera * size;
      Arrays.fill(out, at, at + views * VIEW.size(), 0);
      write(network, camera, out, at);
    }
  }

  private void write(NetworkView network, int camera, float[] out, int first) {
    ViewOutlook outlook = belief.outlook(camera);
    double greatest =
        IntStream.range(0, outlook.views()).mapToDouble(outlook::gain).max().orElse(0);
    for (int view = 0; view < Math.min(views, outlook.views()); view++) {
      int at = first + view * VIEW.size();
      out[at] = 1;
      out[at + 1] = network.view(camera) == view ? 1 : 0;
      out[at + 2] = network.seeing(camera) == view ? 1 : 0;
      writeTargets(outlook, view, out, at + 3);
      out[at + 8] = count(outlook.gain(view));
      out[at + 9] = Bounds.share(outlook.gain(view) / greatest);
    }
  }

  private static void writeTargets(ViewOutlook outlook, int view, float[] out, int at) {
    out[at] = count(outlook.delay(view));
    out[at + 1] = count(outlook.targets(view));
    out[at + 2] = Bounds.share(outlook.covered(view) / outlook.targets(view));
    out[at + 3] = count(outlook.known(view));
    out[at + 4] = count(outlook.unseen(view));
  }

  private static float count(double number) {
    return Bounds.share(number / (number + 1));
  }
}
