package org.hificamsim.network.agent;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.function.IntUnaryOperator;
import java.util.stream.Stream;
import org.hificamsim.core.world.Cameras;

/**
 * One camera as a trader of targets (behaviour 8.1): it advertises what it owns, bids for what
 * others sell, and settles its own auctions (behaviour 8.3 to 8.5). An auction opened in a step is
 * settled in it.
 *
 * <p>What it owns, and what others bid, are in hash maps as CamSim has them: its numbers depend on
 * their order (behaviour 4.4, 4.5).
 */
public final class Agent {
  /**
   * What all agents share.
   *
   * @param features of all targets that there will ever be
   * @param searches of all agents
   * @param random draws whom Smooth and Step ask
   * @param bidderHash hash code of a camera, which orders the bids of several; null for the order
   *     of arrival
   * @param exactPrices whether a price is the second highest value, and prices paid add up; quirk
   *     Q14 otherwise
   */
  public record Shared(
      Cameras cameras,
      List<Features> features,
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
  private final Map<Features, Integer> owned = new HashMap<>(); // by features
  private final List<List<Bid>> bids; // by target
  private final Mean sharedViews = new Mean();
  private CommunicationPolicy policy;
  private double received;
  private double paid;

  /** What CamSim knows a target by: a list of one number. */
  public record Features(double value) {
    @Override
    public int hashCode() {
      return 31 + Double.hashCode(value);
    }
  }

  /** A camera's bid, with that camera's hash code then. */
  private record Bid(int camera, double value, int hash) {
    @Override
    public int hashCode() {
      return hash;
    }
  }

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
    bids =
        Stream.generate(() -> (List<Bid>) new ArrayList<Bid>(0))
            .limit(shared.features().size())
            .toList();
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

  /** The targets owned, in the order of the map that holds them; for reading only. */
  public Collection<Integer> owned() {
    return owned.values();
  }

  /** The same targets in the order of a copy of that map. */
  public Collection<Integer> copyOfOwned() {
    if (owned.size() < 2) {
      return owned.values();
    }
    Map<Features, Integer> copy = new HashMap<>();
    owned.forEach(copy::put);
    return copy.values();
  }

  private boolean owns(int target) {
    return owned.containsKey(shared.features().get(target));
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
        if (sees(target) && !owns(target)) {
          countView(true);
        }
      }
      case FOUND -> {
        if (contacts.neighbours.get(from) && contacts.asked(target) != null) {
          note(target, from, value);
        }
      }
      case START_TRACKING -> {
        pay(value);
        own(target);
      }
    }
  }

  /** The first bid of each camera counts. */
  private void note(int target, int from, double value) {
    for (Bid bid : bids.get(target)) {
      if (bid.camera == from) {
        return;
      }
    }
    boolean byHash = shared.bidderHash() != null;
    int hash = byHash ? shared.bidderHash().applyAsInt(from) : 0;
    bids.get(target).add(new Bid(from, value, hash));
  }

  /** Counts a target that this camera and another see, or one of them alone. */
  private void countView(boolean both) {
    sharedViews.add(both ? 1 : 0, 1);
  }

  private void own(int target) {
    owned.put(shared.features().get(target), target);
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
    for (int target : owned()) {
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
      if (searcher == Searches.NONE || owns(target)) {
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
    searches.own(camera, owned()).forEach(this::settle);
    schedule.settled();
  }

  private void settle(int target) {
    double best = value(target);
    List<Bid> offers = bids.get(target);
    if (offers.isEmpty()) {
      if (sees(target)) {
        countView(false);
      }
      return;
    }
    double beforeBest = best;
    double second = 0;
    int winner = camera;
    for (Bid offer : inOrder(offers)) {
      double value = offer.value;
      if (!contacts.reaches(offer.camera)) {
        continue;
      }
      if (value > best) {
        second = best;
        beforeBest = best;
        best = value;
        winner = offer.camera;
      } else if (value > second) {
        second = value;
      }
    }
    int count = offers.size();
    offers.clear();
    sell(target, winner, shared.exactPrices() ? second : beforeBest, count);
  }

  private Collection<Bid> inOrder(List<Bid> arrived) {
    if (shared.bidderHash() == null || arrived.size() < 2) {
      return arrived;
    }
    Set<Bid> byHash = new HashSet<>();
    byHash.addAll(arrived); // one by one, as CamSim's map grows
    return byHash;
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
      owned.remove(shared.features().get(target));
      countView(sees(target));
    }
    policy.stopSearch(contacts, target);
    searches.end(camera, target);
  }
}
