package org.hificamsim.onnx;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.agents.cooperative.SharedBelief;
import org.hificamsim.agents.observation.CameraObserver;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.worlds.Masks;
import org.hificamsim.worlds.PlayedPolicy;

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
  private CameraObserver observer;
  private Masks masks;
  private PlayedPolicy played;
  private int[] choices;
  private ObservationLayout layout;
  private float[] observations;

  /** What the network reads: the observations, or the belief in them. */
  private float[] read;

  private float[] state;
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
    Conventions conventions = trained.conventions();
    int width = Masks.width(network, conventions.actions());
    layout = trained.layout(network);
    trained.requireShapes(network.cameras(), layout, width);
    choices = conventions.actions().choices(network);
    masks = new Masks(network, conventions.actions());
    played = new PlayedPolicy(conventions.actions());
    observations = new float[network.cameras() * layout.size()];
    boolean viewsAlone = conventions.seesViewsAlone();
    int viewNumbers = network.cameras() * layout.views() * ObservationLayout.viewSize();
    read = viewsAlone ? new float[viewNumbers] : observations;
    state = new float[network.cameras() * trained.stateSize()];
    values = new float[network.cameras() * width];
    actions = new int[network.cameras() * choices.length];
    observer = null;
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    if (views.length > 0) {
      observe(network);
      trained.value(views.length, read, state, values);
      choose(masks.of(network));
      played.play(actions);
      played.decide(network, views);
    }
  }

  private void observe(NetworkView network) {
    if (observer == null) {
      observer = new CameraObserver(network, layout);
      played.observeWith(observer);
    }
    observer.observe(network, observations);
    if (read != observations) {
      copyBelief(network.cameras());
    }
  }

  private void copyBelief(int cameras) {
    int size = layout.size() - layout.firstView();
    for (int camera = 0; camera < cameras; camera++) {
      int from = camera * layout.size() + layout.firstView();
      System.arraycopy(observations, from, read, camera * size, size);
    }
  }

  @Override
  public long messages() {
    return belief() == null ? 0 : belief().messages();
  }

  @Override
  public long bits() {
    return belief() == null ? 0 : belief().bits();
  }

  private SharedBelief belief() {
    return observer == null ? null : observer.belief();
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
