package org.hificamsim.worlds.program;

import java.io.Closeable;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Texts;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.program.Sandbox;
import org.hificamsim.core.registry.Options;
import org.hificamsim.worlds.ActionKind;
import org.hificamsim.worlds.Masks;
import org.hificamsim.worlds.ObservedPlay;

/**
 * A policy in a Python file, {@code python:FILE}. The file has a {@code policy}, a function of
 * observations, float32 (cameras, numbers), and masks, uint8 (cameras, choices), that returns an
 * action for each camera; its method {@code begin}, if it has one, is called before each episode.
 * {@code WEIGHTS} is the path of the file that the option {@code weights} names. Each episode runs
 * in a process of its own, which gets nothing else ({@link Sandbox}).
 */
public final class PythonPolicy implements ZoomPolicy, Closeable {
  private static final int MAX_OBSERVED = 1_000;

  private String file = "";
  private String weights = "";
  private ObservationLayout layout = ObservationLayout.DEFAULT;
  private boolean belief;
  private ActionKind kind = ActionKind.VIEW;
  private Sandbox sandbox = new Sandbox(1, 1);
  private ObservedPlay play;
  private PolicyProgram program;

  @Override
  public String name() {
    return "python";
  }

  @Override
  public void configure(Options options) {
    file = options.mainText("file", "", "the policy, in Python");
    weights = options.text("weights", "", "a file that the policy reads as WEIGHTS");
    belief = options.choice("belief", Answer.NO, "whether it observes the belief") == Answer.YES;
    kind = options.choice("actions", ActionKind.VIEW, "what an action is: view, steps");
    int targets = options.integer("targets", 4, 0, MAX_OBSERVED, "that it observes");
    int neighbours = options.integer("neighbours", 2, 0, MAX_OBSERVED, "that it observes");
    layout = new ObservationLayout(targets, neighbours, false);
    sandbox =
        new Sandbox(
            options.integer("seconds", 300, 1, 86_400, "of processor time for an episode"),
            options.integer("memory", 4096, 64, 1_000_000, "that it may take, megabytes"));
    if (kind == ActionKind.RATES) {
      throw new InputException("policy python: actions is 'rates', expected view or steps");
    }
    if (!file.isEmpty()) {
      requireReadable();
    }
  }

  private void requireReadable() {
    requireReadable("file", file);
    if (!weights.isEmpty()) {
      requireReadable("weights", weights);
    }
  }

  private static void requireReadable(String option, String path) {
    if (!Files.isRegularFile(Path.of(path)) || !Files.isReadable(Path.of(path))) {
      throw InputException.of(
          "policy python: %s is '%s', expected a readable file: python:FILE,weights=FILE",
          option, path);
    }
  }

  private enum Answer {
    YES,
    NO
  }

  @Override
  public List<Path> files() {
    return Stream.of(file, weights).filter(name -> !name.isEmpty()).map(Path::of).toList();
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    close();
    requireReadable();
    ObservationLayout used = belief ? layout.withBelief(network) : layout;
    play = new ObservedPlay(network, kind, used);
    String header =
        Texts.format(
            "{\"cameras\": %d, \"numbers\": %d, \"choices\": %d, \"actions\": %d}\n",
            network.cameras(), used.size(), Masks.width(network, kind), kind.numbers());
    program = new PolicyProgram(files(), header, sandbox);
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    if (views.length > 0) {
      program.decide(play.observe(network), play.masks(network), play.actions());
      requireChoices(network);
      play.decide(network, views);
    }
  }

  private void requireChoices(NetworkView network) {
    int[] actions = play.actions();
    for (int i = 0; i < actions.length; i++) {
      int count = play.choices(i);
      if (actions[i] < 0 || actions[i] >= count) {
        throw InputException.of(
            "%s: action %s of camera %s in step %s, expected 0 to %s",
            file, actions[i], network.cameraName(play.camera(i)), network.step(), count - 1);
      }
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

  @Override
  public void close() {
    if (program != null) {
      program.close();
      program = null;
    }
  }
}
