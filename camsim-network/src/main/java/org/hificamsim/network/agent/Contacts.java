package org.hificamsim.network.agent;

import java.util.BitSet;
import org.hificamsim.core.world.Cameras;

/**
 * The cameras that one camera knows: its neighbours, its links in the vision graph, and the cameras
 * it has asked about each target. Sends messages to them (behaviour 8.1, 8.2).
 */
final class Contacts {
  final BitSet neighbours = new BitSet();
  final Links links;
  private final BitSet advertised = new BitSet();

  /** The names asked, by target; null if the target was never advertised. */
  private final BitSet[] asked;

  private final int camera;
  private final Agent.Shared shared;
  private boolean countsFallback = true;
  private int attempts;

  Contacts(int camera, Links links, Agent.Shared shared) {
    this.camera = camera;
    this.links = links;
    this.shared = shared;
    asked = new BitSet[shared.keys().count()];
  }

  /** Returns whether a message to a name arrives; not all names are cameras. */
  boolean reaches(int name) {
    Cameras cameras = shared.cameras();
    return name < cameras.count() && neighbours.get(name) && cameras.online(name);
  }

  /** The strength of the link to a camera; an offline camera has none, since its name differs. */
  double linkTo(int other, int target) {
    return shared.cameras().online(other) ? links.strength(other, target) : Links.NONE;
  }

  /** Draws a number in [0, 1) that decides which cameras to ask. */
  double draw() {
    return shared.random().nextDouble();
  }

  /** Sends a message; it is lost without notice if the camera does not reach the name. */
  void send(MessageKind kind, int to, int target, double value) {
    if (reaches(to)) {
      shared.queue().send(kind, camera, to, target, value);
    }
  }

  /** Sends a message without a value to all neighbours. */
  void sendToNeighbours(MessageKind kind, int target) {
    shared.queue().send(kind, camera, MessageQueue.NEIGHBOURS, target, 0);
  }

  /** Asks a neighbour to bid for a target; an offline neighbour does not answer (quirk Q7). */
  void ask(int neighbour, int target) {
    attempts++;
    recordAsked(neighbour, target);
    send(MessageKind.START_SEARCH, neighbour, target, 0);
  }

  /** Asks all neighbours to bid for a target. */
  void askNeighbours(int target) {
    attempts += neighbours.cardinality();
    advertise(target);
    if (links != Links.UNREAD) { // A camera that always asks all neighbours need not record them.
      for (int name = neighbours.nextSetBit(0); name >= 0; name = neighbours.nextSetBit(name + 1)) {
        recordAsked(name, target);
      }
    }
    sendToNeighbours(MessageKind.START_SEARCH, target);
  }

  /** Asks all neighbours, because the policy has selected none. */
  void askNeighboursAsFallback(int target) {
    int before = attempts;
    askNeighbours(target);
    attempts = countsFallback ? attempts : before;
  }

  private void recordAsked(int neighbour, int target) {
    advertise(target);
    if (shared.cameras().online(neighbour)) {
      asked[target].set(neighbour);
    }
  }

  /** Marks a target as advertised, without naming a camera that was asked. */
  void advertise(int target) {
    if (!advertised.get(target)) {
      advertised.set(target);
      asked[target] = asked[target] == null ? new BitSet() : asked[target];
      asked[target].clear();
    }
  }

  /** Marks a target as no longer advertised. */
  void withdraw(int target) {
    advertised.clear(target);
  }

  /** The names that were asked about a target; null if it is not advertised. */
  BitSet asked(int target) {
    return advertised.get(target) ? asked[target] : null;
  }

  /** Returns whether the camera advertises any target. */
  boolean advertises() {
    return !advertised.isEmpty();
  }

  /** Thaws the links, and stops counting the messages of the fallback. */
  void beginSwitching() {
    countsFallback = false;
    links.thaw();
  }

  /** The number of StartSearch messages attempted since the last settlement began. */
  int attempts() {
    return attempts;
  }

  /** Fades the links and counts messages from 0 again, before auctions are settled. */
  void beginSettlement() {
    attempts = 0;
    links.fade();
  }
}
