package org.hificamsim.onnx;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.agents.observation.CameraObserver;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.worlds.Masks;
import org.hificamsim.worlds.PlayedPolicy;

/**
 * A policy that was trained elsewhere, {@code onnx:FILE}. Each camera takes the allowed action to
 * which the network in the file gives the highest value. One call values the actions of all
 * cameras.
 */
public final class OnnxPolicy implements ZoomPolicy {
  private static final String EXPECTED = "expected a trained network: onnx:FILE";

  private String file = "";
  private TrainedNetwork trained;
  private CameraObserver observer;
  private Masks masks;
  private PlayedPolicy played;
  private int[] choices;
  private float[] observations;
  private float[] values;
  private int[] actions;

  @Override
  public String name() {
    return "onnx";
  }

  @Override
  public void configure(Options options) {
    file = options.mainText("file", "", "the trained network, in ONNX format");
    files().forEach(TrainedNetwork::requireReadable);
  }

  @Override
  public List<Path> files() {
    try {
      return file.isEmpty() ? List.of() : List.of(Path.of(file));
    } catch (InvalidPathException e) {
      throw new InputException("policy onnx: file is '" + file + "', " + EXPECTED, e);
    }
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    if (file.isEmpty()) {
      throw new InputException("policy onnx: no file, " + EXPECTED);
    }
    trained = TrainedNetwork.of(files().get(0));
    TrainedNetwork.Conventions conventions = trained.conventions();
    int width = Masks.width(network, conventions.actions());
    trained.requireShapes(network.cameras(), width);
    choices = conventions.actions().choices(network);
    masks = new Masks(network, conventions.actions());
    played = new PlayedPolicy(conventions.actions());
    observations = new float[network.cameras() * conventions.layout().size()];
    values = new float[network.cameras() * width];
    actions = new int[network.cameras() * choices.length];
    observer = null;
  }

  @Override
  public void decide(NetworkView network, int[] views) {
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

  /**
   * Sets each component of each action to the allowed choice of the highest value; the first one
   * wins a tie.
   */
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
