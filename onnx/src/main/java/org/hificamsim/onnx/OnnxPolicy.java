package org.hificamsim.onnx;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.agents.cooperative.SharedBelief;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.worlds.Masks;
import org.hificamsim.worlds.ObservedPlay;

/**
 * A policy that was trained elsewhere, {@code onnx:FILE}. Each camera takes the allowed action to
 * which the network in the file gives the highest value. One call values the actions of all
 * cameras. A network that reads the shared belief has the cameras send the messages of {@link
 * SharedBelief}.
 */
public final class OnnxPolicy implements ZoomPolicy {
  private static final String EXPECTED = "expected a trained network: onnx:FILE";

  private String file = "";
  private TrainedNetwork trained;
  private ObservedPlay play;
  private ObservationLayout layout;

  /** The belief in the observations; null unless the network reads nothing else. */
  private float[] beliefs;

  private float[] state;
  private float[] values;

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
    Conventions conventions = trained.conventions();
    int width = Masks.width(network, conventions.actions());
    layout = trained.layout(network);
    trained.requireShapes(network.cameras(), layout, width);
    play = new ObservedPlay(network, conventions.actions(), layout);
    int beliefNumbers = layout.views() * ObservationLayout.viewSize();
    beliefs = conventions.seesViewsAlone() ? new float[network.cameras() * beliefNumbers] : null;
    state = new float[network.cameras() * trained.stateSize()];
    values = new float[network.cameras() * width];
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    if (views.length > 0) {
      float[] observations = play.observe(network);
      if (beliefs != null) {
        copyBeliefs(observations, views.length);
      }
      trained.value(views.length, beliefs == null ? observations : beliefs, state, values);
      choose(play.masks(network));
      play.decide(network, views);
    }
  }

  private void copyBeliefs(float[] observations, int cameras) {
    int size = layout.size() - layout.firstView();
    for (int camera = 0; camera < cameras; camera++) {
      int from = camera * layout.size() + layout.firstView();
      System.arraycopy(observations, from, beliefs, camera * size, size);
    }
  }

  @Override
  public long messages() {
    return play == null ? 0 : play.messages();
  }

  @Override
  public long bits() {
    return play == null ? 0 : play.bits();
  }

  /**
   * Sets each component of each action to the allowed choice of the highest value; the first one
   * wins a tie.
   */
  private void choose(byte[] allowed) {
    int[] actions = play.actions();
    int from = 0;
    for (int i = 0; i < actions.length; i++) {
      int count = play.choices(i);
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
