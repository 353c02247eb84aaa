package org.hificamsim.network.agent;

import java.util.Random;
import java.util.function.IntUnaryOperator;
import org.hificamsim.core.world.Cameras;

/**
 * One camera as a trader of targets (behaviour 8.1): it advertises the targets it owns, bids for
 * those that others sell, and settles its own auctions (behaviour 8.3 to 8.5). An auction opened in
 * a step is settled in it.
 *
 * <p>Owned targets and bids have the order of CamSim's hash maps, since its numbers depend on it
 * (behaviour 4.4, 4.5).
 */
public final class Agent {
  /**
   * Objects that all agents share.
   *
   * @param keys the keys of all targets, including those that events will add
   * @param searches the searches of all agents
   * @param random the generator that draws the cameras which Smooth and Step ask
   * @param bidderHash the hash code of a camera, which orders bids; null for the order of arrival
   * @param exactPrices whether a price is the second highest value, and prices paid add up; false
   *     for quirk Q14
   */
  public record Shared(
      Cameras cameras,
      TargetKeys keys,
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
  private final Bids[] bidsByTarget;
  private final Mean sharedViews = new Mean();
  private CommunicationPolicy policy;
  private double received;
  private double paid;

  /**
   * Creates an agent without targets and neighbours.
   *
   * @param limit the number of owned targets at which it claims no more; 0 for no limit
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
    owned = new OwnedTargets(shared.keys());
    contacts = new Contacts(camera, links, shared);
    bidsByTarget = new Bids[shared.keys().count()];
    searches = shared.searches();
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
   * Switches to another schedule and policy, chosen by a bandit (behaviour 9.4). All state is kept,
   * links are no longer frozen, and messages of the fallback to Broadcast are no longer counted.
   */
  public void switchTo(ScheduleKind newSchedule, CommunicationPolicy newPolicy) {
    schedule.switchTo(newSchedule);
    policy = newPolicy;
    contacts.beginSwitching();
  }

  /** Adds another camera to the neighbours. */
  public void addNeighbour(int other) {
    contacts.neighbours.set(other);
  }

  /** Permanently forgets all other cameras (behaviour 7, step 4). */
  public void forgetNeighbours() {
    contacts.neighbours.clear();
  }

  /** The number of neighbours. */
  int neighbours() {
    return contacts.neighbours.cardinality();
  }

  /** Returns whether a message to another camera arrives. */
  public boolean reaches(int other) {
    return contacts.reaches(other);
  }

  /** Starts a search for a new target that nobody owns. */
  public void lookFor(int target) {
    searches.begin(camera, target, Searches.NOBODY);
  }

  /** The owned targets. */
  public OwnedTargets owned() {
    return owned;
  }

  /** The confidence with which the camera sees a target; 0 if it does not see it. */
  public double confidence(int target) {
    return shared.sightings().confidence(camera, target);
  }

  /** Returns whether the camera sees a target. */
  public boolean sees(int target) {
    return shared.sightings().sees(camera, target);
  }

  /** The mean share of seen targets that other cameras also see (behaviour 9.6). */
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

  /** The number of StartSearch messages attempted since the last settlement began. */
  public int attempts() {
    return contacts.attempts();
  }

  /**
   * Receives a message (behaviour 8.2).
   *
   * @param value the value of a bid, or the price; 0 for other messages
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
        if (contacts.neighbours.get(from) && contacts.asked(target) != null) {
          recordBid(target, from, value);
        }
      }
      case START_TRACKING -> {
        pay(value);
        takeOwnership(target);
      }
    }
  }

  /** Records a bid, unless the bidder has already bid. */
  private void recordBid(int target, int from, double value) {
    if (bidsByTarget[target] == null) {
      bidsByTarget[target] = new Bids();
    }
    boolean orderedByHash = shared.bidderHash() != null;
    int hash = orderedByHash ? shared.bidderHash().applyAsInt(from) : 0;
    bidsByTarget[target].add(from, value, hash);
  }

  /** Counts a target that this camera and another both see, or that only one of them sees. */
  private void countView(boolean both) {
    sharedViews.add(both ? 1 : 0, 1);
  }

  private void takeOwnership(int target) {
    owned.add(target);
    searches.end(camera, target);
  }

  private void pay(double price) {
    paid = shared.exactPrices() ? paid + price : price;
  }

  /**
   * The value of a target to the camera: its own bid, and the value that other bids have to exceed.
   */
  private double value(int target) {
    return schedule.value(target, confidence(target));
  }

  /** Offers its targets for sale, in the order of the map that holds them (behaviour 8.3). */
  public void advertise() {
    for (int i = 0; i < owned.count(); i++) {
      int target = owned.target(i);
      if (schedule.advertises(target, confidence(target))) {
        searches.begin(camera, target, camera);
        policy.startSearch(contacts, target);
      }
    }
  }

  /**
   * Bids for visible targets that others sell, and claims those that nobody owns (behaviour 8.4).
   */
  public void bid() {
    Sightings sightings = shared.sightings();
    int claimed = 0;
    for (int i = 0; i < sightings.visibleCount(camera); i++) {
      int target = sightings.visible(camera, i);
      int searcher = searches.searcher(camera, target);
      if (searcher == Searches.NONE || owned.contains(target)) {
        continue;
      }
      if (searcher == camera) {
        takeOwnership(target);
        policy.stopSearch(contacts, target);
      } else if (searcher != Searches.NOBODY) {
        contacts.send(MessageKind.FOUND, searcher, target, value(target));
      } else if (limit == 0 || limit > claimed + owned.count()) {
        claim(target);
        claimed++;
      }
    }
  }

  private void claim(int target) {
    takeOwnership(target);
    pay(0);
    CommunicationPolicy.BROADCAST.stopSearch(contacts, target);
  }

  /** Settles the auctions of this camera (behaviour 8.5). */
  public void settleAuctions() {
    received = 0;
    paid = 0;
    contacts.beginSettlement();
    for (int target : searches.ownSearches(camera, owned)) {
      settleAuction(target);
    }
    schedule.endStep();
  }

  private void settleAuction(int target) {
    double best = value(target);
    Bids offers = bidsByTarget[target];
    if (offers == null || offers.count() == 0) {
      if (sees(target)) {
        countView(false);
      }
      return;
    }
    double beforeBest = best;
    double second = 0;
    int winner = camera;
    for (int i = 0; i < offers.count(); i++) {
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
    int count = offers.count();
    offers.clear();
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
      if (contacts.asked(target) != null) {
        contacts.asked(target).clear(winner);
      }
      owned.remove(target);
      countView(sees(target));
    }
    policy.stopSearch(contacts, target);
    searches.end(camera, target);
  }
}
