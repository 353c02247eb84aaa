package org.hificamsim.worlds;

import java.util.SplittableRandom;
import java.util.function.Supplier;
import org.hificamsim.agents.observation.CameraObserver;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * Carries out given actions. Another policy, the expert, may give advice in each step, which an
 * action can adopt.
 */
public final class PlayedPolicy implements ZoomPolicy {
  /** The action by which a camera follows the advice of the expert. */
  public static final int AS_ADVISED = -1;

  /** The advice for a camera that does not decide, since it is offline or moving. */
  public static final int NO_ADVICE = -1;

  private final ActionKind kind;
  private final Supplier<ZoomPolicy> expertFactory;
  private ZoomPolicy expert;
  private Steering steering;
  private int[] actions = {};
  private int[] expertViews = {};
  private int[] advice = {};
  private CameraObserver observer;

  /** Creates a policy without an expert. */
  public PlayedPolicy(ActionKind kind) {
    this(kind, null);
  }

  /**
   * @param expertFactory creates an expert for each episode; null for none
   */
  PlayedPolicy(ActionKind kind, Supplier<ZoomPolicy> expertFactory) {
    this.kind = kind;
    this.expertFactory = expertFactory;
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    steering = null;
    advice = new int[network.cameras()];
    if (expertFactory != null) {
      expert = expertFactory.get();
      expert.begin(network, random);
      expertViews = new int[advice.length];
    }
  }

  @Override
  public void learn(NetworkView network) {
    if (expert != null) {
      expert.learn(network);
    }
  }

  /**
   * Returns the view that the expert chose for each camera at the last decision, or {@link
   * #NO_ADVICE}.
   */
  int[] advice() {
    return advice;
  }

  /**
   * Sets the actions of the next decision.
   *
   * @param newActions one camera after the other; read at the next decision
   */
  public void play(int[] newActions) {
    actions = newActions;
  }

  /**
   * Sets the observer of the cameras, which receives the views that they choose.
   *
   * @param newObserver null for none
   */
  public void observeWith(CameraObserver newObserver) {
    observer = newObserver;
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
        views[camera] = expertViews[camera];
        steering.setView(network, camera, expertViews[camera]);
      } else if (network.online(camera) && (kind == ActionKind.RATES || !network.moving(camera))) {
        views[camera] = kind.view(network, camera, actions, camera * kind.numbers(), steering);
      }
    }
    if (observer != null) {
      observer.learnChoices(network, views);
    }
  }

  private void advise(NetworkView network, int[] views) {
    System.arraycopy(views, 0, expertViews, 0, views.length);
    expert.decide(network, expertViews);
    for (int camera = 0; camera < views.length; camera++) {
      boolean decides = network.online(camera) && !network.moving(camera);
      advice[camera] = decides ? expertViews[camera] : NO_ADVICE;
    }
  }
}
