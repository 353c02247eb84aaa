package org.hificamsim.network.agent;

import java.util.Random;
import java.util.function.IntUnaryOperator;
import org.hificamsim.core.world.Cameras;

/**
 * One camera as a trader of targets (behaviour 8.1): it advertises what it owns, bids for what
 * others sell, and settles its own auctions (behaviour 8.3 to 8.5). An auction opened in a step is
 * settled in it.
 */
public final class Agent {
  /**
   * What all agents share.
   *
   * @param features of all targets that there will ever be
   * @param searches of all agents
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
      Searches searches,
      MessageQueue queue,
      Random random,
      IntUnaryOperator bidderHash,
      boolean exactPrices) {}

  private final int camera;
  private final int limit;
  private final Shared shared;
  private final AuctionSchedule schedule;
  private final Contacts contacts;
  private final Searches searches;
  private final OwnedTargets owned;
  private final Bids bids;
  private final Mean sharedViews = new Mean();
  private CommunicationPolicy policy;
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
    this.shared = shared;
    contacts = new Contacts(camera, links, shared);
    searches = shared.searches();
    owned = new OwnedTargets(shared.features());
    bids = new Bids(shared.features().length);
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
    contacts.beginSwitching();
  }

  /** Gets to know another camera, the last in its list. */
  public void meet(int other) {
    contacts.neighbours.set(other);
  }

  /** Permanently forgets all other cameras (behaviour 7, step 4). */
  public void forgetNeighbours() {
    contacts.neighbours.clear();
  }

  /** The number of cameras that it knows. */
  int neighbours() {
    return contacts.neighbours.cardinality();
  }

  /** Whether a message to this camera arrives. */
  public boolean reaches(int other) {
    return contacts.reaches(other);
  }

  /** Looks for a new target that nobody owns. */
  public void lookFor(int target) {
    searches.begin(camera, target, Searches.NOBODY);
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

  /** The share of the targets seen that others see too (behaviour 9.6). */
  public Mean sharedViews() {
    return sharedViews;
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
    return contacts.sent();
  }

  /**
   * Receives a message (behaviour 8.2).
   *
   * @param value of a bid, or the price
   */
  public void receive(MessageKind kind, int from, int target, double value) {
    switch (kind) {
      case START_SEARCH -> {
        if (contacts.neighbours.get(from)) {
          searches.begin(camera, target, from);
        }
      }
      case STOP_SEARCH -> {
        searches.end(camera, target);
        if (sees(target) && !owned.contains(target)) {
          countView(true);
        }
      }
      case FOUND -> {
        if (contacts.neighbours.get(from) && contacts.advertised.contains(target)) {
          bids.add(target, from, value, shared.bidderHash().applyAsInt(from));
        }
      }
      case START_TRACKING -> {
        pay(value);
        own(target);
      }
    }
  }

  /** Counts a target that this camera and another see, or one of them alone. */
  private void countView(boolean both) {
    sharedViews.add(both ? 1 : 0, 1);
  }

  private void own(int target) {
    owned.add(target);
    searches.end(camera, target);
  }

  private void pay(double price) {
    paid = shared.exactPrices() ? paid + price : price;
  }

  /** What a target is worth to the camera: its bid, and what a bid has to exceed. */
  private double value(int target) {
    return schedule.value(target, confidence(target));
  }

  /** Offers its targets for sale, in the order of the map that holds them (behaviour 8.3). */
  public void advertise() {
    for (int i = 0; i < owned().size(); i++) {
      int target = owned().get(i);
      if (schedule.advertises(target, confidence(target))) {
        searches.begin(camera, target, camera);
        policy.startSearch(contacts, target);
      }
    }
  }

  /** Bids for targets in view that others sell, and claims those nobody owns (behaviour 8.4). */
  public void bid() {
    Sightings sightings = shared.sightings();
    int claimed = 0;
    for (int i = 0; i < sightings.visible(camera); i++) {
      int target = sightings.visible(camera, i);
      int searcher = searches.searcher(camera, target);
      if (searcher == Searches.NONE || owned.contains(target)) {
        continue;
      }
      if (searcher == camera) {
        own(target);
        policy.stopSearch(contacts, target);
      } else if (searcher != Searches.NOBODY) {
        contacts.send(MessageKind.FOUND, searcher, target, value(target));
      } else if (limit == 0 || limit > claimed + owned().size()) {
        claim(target);
        claimed++;
      }
    }
  }

  private void claim(int target) {
    own(target);
    pay(0);
    CommunicationPolicy.BROADCAST.stopSearch(contacts, target);
  }

  /** Settles its auctions (behaviour 8.5). */
  public void settle() {
    received = 0;
    paid = 0;
    contacts.beginSettlement();
    int own = searches.findOwn(camera, owned());
    for (int i = 0; i < own; i++) {
      settle(searches.own(i));
    }
    schedule.settled();
  }

  private void settle(int target) {
    double best = value(target);
    Bids.OfTarget offers = bids.of(target);
    if (offers == null) {
      if (sees(target)) {
        countView(false);
      }
      return;
    }
    double beforeBest = best;
    double second = 0;
    int winner = camera;
    for (int i = 0; i < offers.size(); i++) {
      double value = offers.value(i);
      if (!contacts.reaches(offers.bidder(i))) {
        continue;
      }
      if (value > best) {
        second = best;
        beforeBest = best;
        best = value;
        winner = offers.bidder(i);
      } else if (value > second) {
        second = value;
      }
    }
    int count = offers.size();
    bids.clear(target);
    sell(target, winner, shared.exactPrices() ? second : beforeBest, count);
  }

  private void sell(int target, int winner, double price, int count) {
    received += price;
    if (winner == camera) {
      pay(price);
      if (sees(target) && count > 1) {
        countView(true);
      }
    } else {
      contacts.send(MessageKind.START_TRACKING, winner, target, price);
      contacts.links.strengthen(winner, target);
      contacts.advertised.remove(target, winner);
      owned.remove(target);
      countView(sees(target));
    }
    policy.stopSearch(contacts, target);
    searches.end(camera, target);
  }
}
