package org.hificamsim.network.agent;

import java.util.BitSet;
import org.hificamsim.core.world.Cameras;

/**
 * Whom one camera knows: its neighbours, its part of the vision graph, and whom it asked about each
 * of its targets; and its way to reach them (behaviour 8.1, 8.2).
 */
final class Contacts {
  final BitSet neighbours = new BitSet();
  final Links links;
  private final BitSet advertised = new BitSet();
  private final BitSet[] asked; // by target that is or was advertised
  private final int camera;
  private final Agent.Shared shared;
  private boolean countsFallback = true;
  private int sent;

  Contacts(int camera, Links links, Agent.Shared shared) {
    this.camera = camera;
    this.links = links;
    this.shared = shared;
    asked = new BitSet[shared.features().size()];
  }

  /** Whether a message to this name arrives; not all names are cameras. */
  boolean reaches(int name) {
    Cameras cameras = shared.cameras();
    return name < cameras.count() && neighbours.get(name) && cameras.online(name);
  }

  /** Strength of the link to a camera under its current name: one that is offline has none. */
  double linkTo(int other, int target) {
    return shared.cameras().online(other) ? links.strength(other, target) : Links.NONE;
  }

  /** A number in [0, 1) that decides whom to ask. */
  double draw() {
    return shared.random().nextDouble();
  }

  /** Sends a message; one to a name that it does not reach is lost without notice. */
  void send(MessageKind kind, int to, int target, double value) {
    if (reaches(to)) {
      shared.queue().send(kind, camera, to, target, value);
    }
  }

  /** Sends a message without a value to all neighbours. */
  void sendToNeighbours(MessageKind kind, int target) {
    shared.queue().send(kind, camera, MessageQueue.NEIGHBOURS, target, 0);
  }

  /** Asks a neighbour to bid for a target; one that is offline does not answer (quirk Q7). */
  void ask(int neighbour, int target) {
    sent++;
    noteAsked(neighbour, target);
    send(MessageKind.START_SEARCH, neighbour, target, 0);
  }

  /** Asks all neighbours to bid for a target. */
  void askNeighbours(int target) {
    sent += neighbours.cardinality();
    advertise(target);
    if (links != Links.UNREAD) { // else it always asks all of them
      for (int name = neighbours.nextSetBit(0); name >= 0; name = neighbours.nextSetBit(name + 1)) {
        noteAsked(name, target);
      }
    }
    sendToNeighbours(MessageKind.START_SEARCH, target);
  }

  /** The same where there was nobody in particular to ask. */
  void askNeighboursInstead(int target) {
    int before = sent;
    askNeighbours(target);
    sent = countsFallback ? sent : before;
  }

  private void noteAsked(int neighbour, int target) {
    advertise(target);
    if (shared.cameras().online(neighbour)) {
      asked[target].set(neighbour);
    }
  }

  /** A target is advertised from now on, though no camera that can be named was asked. */
  void advertise(int target) {
    if (!advertised.get(target)) {
      advertised.set(target);
      asked[target] = asked[target] == null ? new BitSet() : asked[target];
      asked[target].clear();
    }
  }

  /** A target is advertised no longer. */
  void withdraw(int target) {
    advertised.clear(target);
  }

  /** The names that were asked about a target; null where it is not advertised. */
  BitSet asked(int target) {
    return advertised.get(target) ? asked[target] : null;
  }

  /** Whether it advertises any target. */
  boolean advertises() {
    return !advertised.isEmpty();
  }

  /** From now on links fade and grow, and asking all neighbours instead does not count as sent. */
  void beginSwitching() {
    countsFallback = false;
    links.thaw();
  }

  /** How many StartSearch messages were attempted since the last settlement began. */
  int sent() {
    return sent;
  }

  /** A settlement begins: links fade, messages are counted from 0. */
  void beginSettlement() {
    sent = 0;
    links.decay();
  }
}
