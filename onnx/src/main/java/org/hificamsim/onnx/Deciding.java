package org.hificamsim.onnx;

import org.hificamsim.agents.observation.CameraObserver;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.worlds.Masks;
import org.hificamsim.worlds.PlayedPolicy;

/** A trained network at work in one run: observe, value, choose. */
final class Deciding {
  private final TrainedNetwork trained;
  private final Masks masks;
  private final PlayedPolicy played;
  private final int[] choices;
  private final float[] observations;
  private final float[] values;
  private final int[] actions;
  private CameraObserver observer;

  /**
   * For a network of cameras.
   *
   * @throws org.hificamsim.core.InputException when the trained network is for other cameras
   */
  Deciding(TrainedNetwork trained, NetworkView network) {
    this.trained = trained;
    Conventions conventions = trained.conventions();
    choices = conventions.actions().choices(network);
    masks = new Masks(network, conventions.actions());
    played = new PlayedPolicy(conventions.actions());
    int width = Masks.width(network, conventions.actions());
    trained.requireShapes(network.cameras(), width);
    observations = new float[network.cameras() * conventions.layout().size()];
    values = new float[network.cameras() * width];
    actions = new int[network.cameras() * choices.length];
  }

  void decide(NetworkView network, int[] views) {
    if (views.length > 0) {
      observe(network);
      trained.value(views.length, observations, values);
      choose(masks.of(network));
      played.play(actions);
      played.decide(network, views);
    }
  }

  private void observe(NetworkView network) {
    if (observer == null) {
      observer = new CameraObserver(network, trained.conventions().layout());
    }
    observer.observe(network, observations);
  }

  /** For each number of each action the allowed one of the highest value, the first of equals. */
  private void choose(byte[] allowed) {
    int from = 0;
    for (int i = 0; i < actions.length; i++) {
      int count = choices[i % choices.length];
      actions[i] = best(allowed, from, count);
      from += count;
    }
  }

  private int best(byte[] allowed, int from, int count) {
    int best = -1;
    for (int i = 0; i < count; i++) {
      if (allowed[from + i] != 0 && (best < 0 || values[from + i] > values[from + best])) {
        best = i;
      }
    }
    return best;
  }
}
