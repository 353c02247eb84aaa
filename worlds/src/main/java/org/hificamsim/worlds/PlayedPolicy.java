package org.hificamsim.worlds;

import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * Carries out the actions of a step that it is given, one camera after the other. An expert,
 * another policy, may be asked in each step what it would do, and made to do it.
 */
public final class PlayedPolicy implements ZoomPolicy {
  /** The action by which a camera does what the expert advises. */
  public static final int AS_ADVISED = -1;

  /** The advice to a camera that does not decide: it is offline, or on its way. */
  public static final int NO_ADVICE = -1;

  private final ActionKind kind;
  private final Supplier<ZoomPolicy> experts;
  private ZoomPolicy expert;
  private Steering steering;
  private int[] actions = {};
  private int[] wanted = {};
  private int[] advice = {};

  /** Without an expert. */
  public PlayedPolicy(ActionKind kind) {
    this(kind, null);
  }

  /**
   * @param experts makes one for each episode; null for none
   */
  PlayedPolicy(ActionKind kind, Supplier<ZoomPolicy> experts) {
    this.kind = kind;
    this.experts = experts;
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    steering = null;
    advice = new int[network.cameras()];
    if (experts != null) {
      expert = experts.get();
      expert.begin(network, random);
      wanted = new int[advice.length];
    }
  }

  @Override
  public void learn(NetworkView network) {
    if (expert != null) {
      expert.learn(network);
    }
  }

  /** By camera, the view that the expert chose at the last decision, or {@link #NO_ADVICE}. */
  int[] advice() {
    return advice;
  }

  /**
   * What to do next.
   *
   * @param newActions read at the next decision
   */
  public void play(int[] newActions) {
    actions = newActions;
  }

  @Override
  public String name() {
    return "played";
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    if (expert != null) {
      advise(network, views);
    }
    if (steering == null) {
      steering = new Steering(network);
    }
    for (int camera = 0; camera < views.length; camera++) {
      if (expert != null && actions[camera * kind.numbers()] == AS_ADVISED) {
        views[camera] = wanted[camera];
        steering.at(network, camera, wanted[camera]);
      } else if (network.online(camera) && (kind == ActionKind.RATES || !network.moving(camera))) {
        views[camera] = kind.view(network, camera, actions, camera * kind.numbers(), steering);
      }
    }
  }

  private void advise(NetworkView network, int[] views) {
    System.arraycopy(views, 0, wanted, 0, views.length);
    expert.decide(network, wanted);
    for (int camera = 0; camera < views.length; camera++) {
      boolean decides = network.online(camera) && !network.moving(camera);
      advice[camera] = decides ? wanted[camera] : NO_ADVICE;
    }
  }
}
