package org.hificamsim.worlds;

import org.hificamsim.agents.cooperative.SharedBelief;
import org.hificamsim.agents.observation.CameraObserver;
import org.hificamsim.agents.observation.ObservationLayout;
import org.hificamsim.core.policy.NetworkView;

/**
 * Observes the cameras of a run, and carries out actions that are decided elsewhere: by a trained
 * network, or by a program. In each step, call {@link #observe}, fill in {@link #actions}, and call
 * {@link #decide}.
 */
public final class ObservedPlay {
  private final ObservationLayout layout;
  private final Masks masks;
  private final PlayedPolicy played;
  private final int[] choices;
  private final float[] observations;
  private final int[] actions;
  private CameraObserver observer;

  /**
   * Prepares a run.
   *
   * @param kind the kind of the actions
   * @param layout the layout of the observations
   */
  public ObservedPlay(NetworkView network, ActionKind kind, ObservationLayout layout) {
    this.layout = layout;
    masks = new Masks(network, kind);
    played = new PlayedPolicy(kind);
    choices = kind.choices(network);
    observations = new float[network.cameras() * layout.size()];
    actions = new int[network.cameras() * choices.length];
  }

  /**
   * Observes all cameras.
   *
   * @return numbers of shape (cameras, size of the layout); the same array in each step
   */
  public float[] observe(NetworkView network) {
    if (observer == null) {
      observer = new CameraObserver(network, layout);
      played.observeWith(observer);
    }
    observer.observe(network, observations);
    return observations;
  }

  /** The choices that are allowed in the step, as {@link Masks#compute} returns them. */
  public byte[] masks(NetworkView network) {
    return masks.compute(network);
  }

  /** The actions of the next decision, one camera after the other; to be filled in. */
  public int[] actions() {
    return actions;
  }

  /** The number of choices of a number in {@link #actions}. */
  public int choices(int number) {
    return choices[number % choices.length];
  }

  /** The camera of a number in {@link #actions}. */
  public int camera(int number) {
    return number / choices.length;
  }

  /** Carries out the actions. */
  public void decide(NetworkView network, int[] views) {
    played.play(actions);
    played.decide(network, views);
  }

  /** The number of messages that cameras sent for a belief that they share. */
  public long messages() {
    return belief() == null ? 0 : belief().messages();
  }

  /** The length of these messages, in bits. */
  public long bits() {
    return belief() == null ? 0 : belief().bits();
  }

  private SharedBelief belief() {
    return observer == null ? null : observer.belief();
  }
}
