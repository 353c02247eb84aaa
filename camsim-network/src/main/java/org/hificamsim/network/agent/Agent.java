package org.hificamsim.network.agent;

import java.util.Random;
import java.util.function.IntUnaryOperator;
import org.hificamsim.core.world.Cameras;

/**
 * One camera as a member of the network: its state (behaviour 8.1) and its mail (behaviour 8.2).
 */
public final class Agent {
  /**
   * What all agents share.
   *
   * @param features of all targets that there will ever be
   * @param searches what all look for
   * @param random draws whom Smooth and Step ask
   * @param bidderHash orders the bids of several cameras; the same number for all means the order
   *     of arrival
   * @param exactPrices whether a price is the second highest value, and prices paid add up; quirk
   *     Q14 otherwise
   */
  public record Shared(
      Cameras cameras,
      double[] features,
      Sightings sightings,
      SharedSearches searches,
      MessageQueue queue,
      Random random,
      IntUnaryOperator bidderHash,
      boolean exactPrices) {}

  final Links links;
  final InsertionOrder neighbours;
  final OwnedTargets owned;
  final Searches searches;
  final Advertised advertised;
  final Bids bids;
  final ViewTally tally = new ViewTally();
  private final int camera;
  private final int limit;
  private final Shared shared;
  private final AuctionSchedule schedule;
  private CommunicationPolicy policy;
  private boolean countsFallback = true;
  private int sent;
  private double received;
  private double paid;

  /**
   * An agent that owns nothing and knows nobody.
   *
   * @param limit number of targets owned from which on it claims no other; 0 for no limit
   */
  public Agent(
      int camera,
      int limit,
      AuctionSchedule schedule,
      CommunicationPolicy policy,
      Links links,
      Shared shared) {
    this.camera = camera;
    this.limit = limit;
    this.schedule = schedule;
    this.policy = policy;
    this.links = links;
    this.shared = shared;
    int targets = shared.features().length;
    neighbours = new InsertionOrder(shared.cameras().count());
    owned = new OwnedTargets(shared.features());
    searches = new Searches(camera, shared.searches(), targets);
    advertised = new Advertised(targets);
    bids = new Bids(targets);
  }

  /** The camera's number. */
  public int camera() {
    return camera;
  }

  /** The kind of schedule in force. */
  public ScheduleKind schedule() {
    return schedule.kind();
  }

  /** The policy in force. */
  public CommunicationPolicy policy() {
    return policy;
  }

  /**
   * Takes over another schedule and policy, as a bandit chooses (behaviour 9.4): all state is kept,
   * links are no longer frozen, and what is sent by falling back to Broadcast is not counted.
   */
  public void follow(ScheduleKind newSchedule, CommunicationPolicy newPolicy) {
    schedule.switchTo(newSchedule);
    policy = newPolicy;
    countsFallback = false;
    links.thaw();
    shared.searches().outdate();
  }

  /** Gets to know another camera, the last in its list. */
  public void meet(int other) {
    neighbours.add(other);
    shared.searches().outdate();
  }

  /** Forgets all other cameras, for good (behaviour 7, step 4). */
  public void forgetNeighbours() {
    neighbours.clear();
    shared.searches().outdate();
  }

  /** Looks for a new target that nobody owns. */
  public void lookFor(int target) {
    searches.put(target, Searches.NOBODY);
  }

  /** The targets owned, for reading only. */
  public HashOrder owned() {
    return owned.order();
  }

  /** How sure the camera is of a target now; 0 where it does not see it. */
  public double confidence(int target) {
    return shared.sightings().confidence(camera, target);
  }

  /** Whether the camera sees a target now. */
  public boolean sees(int target) {
    return shared.sightings().sees(camera, target);
  }

  /** Which of its targets others see too. */
  public ViewTally tally() {
    return tally;
  }

  /** The prices received at the last settlement. */
  public double received() {
    return received;
  }

  /** The prices paid since the last settlement began. */
  public double paid() {
    return paid;
  }

  /** How many StartSearch messages were attempted since the last settlement began. */
  public int sent() {
    return sent;
  }

  boolean isOnline() {
    return shared.cameras().online(camera);
  }

  /** Whether it hears all of so many other cameras, and does not count what else it hears. */
  boolean isInReachOf(int others) {
    return neighbours.size() == others && schedule.kind() != ScheduleKind.BANDIT_ZOOM;
  }

  /**
   * Takes a delivered message.
   *
   * @param value that of a bid, a price, or the time at which a search began
   */
  public void receive(MessageKind kind, int from, int target, double value) {
    switch (kind) {
      case START_SEARCH -> {
        if (neighbours.contains(from)) {
          searches.hear(target, from, (long) value);
        }
      }
      case STOP_SEARCH -> stopSearch(target);
      case FOUND -> {
        if (neighbours.contains(from) && advertised.contains(target)) {
          bids.add(target, from, value, shared.bidderHash().applyAsInt(from));
        }
      }
      case START_TRACKING -> {
        pay(value);
        owned.add(target);
        searches.remove(target);
      }
    }
  }

  private void stopSearch(int target) {
    searches.remove(target);
    if (sees(target) && !owned.contains(target)) {
      tally.seenElsewhere();
    }
  }

  InsertionOrder visible() {
    return shared.sightings().visible(camera);
  }

  boolean exactPrices() {
    return shared.exactPrices();
  }

  boolean countsFallback() {
    return countsFallback;
  }

  /** Whether a target is to be offered in this step; asked once per target and step. */
  boolean advertises(int target) {
    return schedule.advertises(target, confidence(target));
  }

  /** What a target is worth to the camera: its bid, and what a bid has to exceed. */
  double value(int target) {
    return schedule.value(target, confidence(target));
  }

  /** A number in [0, 1) that decides whom to ask. */
  double draw() {
    return shared.random().nextDouble();
  }

  /** Whether the camera may claim one more target that nobody owns. */
  boolean mayClaim(int claimedInThisStep) {
    return limit == 0 || limit > claimedInThisStep + owned().size();
  }

  /** Strength of the link to a camera under its current name: one that is offline has none. */
  double linkTo(int other, int target) {
    return shared.cameras().online(other) ? links.strength(other, target) : Links.NONE;
  }

  /** Whether a message to this name would arrive; not all names are cameras. */
  boolean reaches(int name) {
    Cameras cameras = shared.cameras();
    return name < cameras.count() && neighbours.contains(name) && cameras.online(name);
  }

  /** Sends a message; one to a name out of reach is lost silently. */
  void send(MessageKind kind, int to, int target, double value) {
    if (reaches(to)) {
      shared.queue().send(kind, camera, to, target, value);
    }
  }

  /**
   * Asks a neighbour to bid for a target; one that is offline does not answer (quirk Q7).
   *
   * @param counted whether the attempt counts as sent
   */
  void ask(int neighbour, int target, boolean counted) {
    if (counted) {
      sent++;
    }
    if (shared.cameras().online(neighbour)) {
      advertised.add(target, neighbour);
    } else {
      advertised.open(target);
    }
    startSearch(neighbour, target);
  }

  /** Sends a name what it takes to look for one of the camera's targets. */
  void startSearch(int name, int target) {
    send(MessageKind.START_SEARCH, name, target, (double) searches.changed(target));
  }

  /** Whether what is sent to all neighbours may go to everyone at once. */
  boolean reachesAll() {
    return shared.searches().reachingAll();
  }

  /** The same as {@link #ask} of each neighbour, where all are reached. */
  void askAll(int target, boolean counted) {
    if (counted) {
      sent += neighbours.size();
    }
    advertised.addAll(target, shared.searches().listening(), camera);
    sendToAll(MessageKind.START_SEARCH, target, (double) searches.changed(target));
  }

  /** Sends a message to all neighbours, where all are reached. */
  void sendToAll(MessageKind kind, int target, double value) {
    int others = shared.searches().listening().cardinality() - 1;
    shared.queue().sendToAll(kind, camera, others, target, value);
  }

  /** Notes a price paid for a target. */
  void pay(double price) {
    paid = exactPrices() ? paid + price : price;
  }

  /** Notes a price received for a target. */
  void earn(double price) {
    received += price;
  }

  /** Begins the settlement: counters start at 0, links fade. */
  void beginSettlement() {
    sent = 0;
    received = 0;
    paid = 0;
    links.decay();
  }

  /** Ends the settlement. */
  void endSettlement() {
    schedule.settled();
  }
}
