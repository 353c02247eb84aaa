package org.hificamsim.network.agent;

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
   * @param bidderHash the hash code that orders a camera's bids, or null for the order of arrival
   * @param pricesAddUp whether prices paid within a step add up; in CamSim the last one stands
   *     (quirk Q14)
   */
  public record Surroundings(
      Cameras cameras,
      double[] features,
      Sightings sightings,
      MessageQueue queue,
      IntUnaryOperator bidderHash,
      boolean pricesAddUp) {}

  private final int camera;
  private final int limit;
  private final Surroundings around;
  private final Links links;
  private final Neighbours neighbours;
  private final OwnedTargets owned;
  private final Searches searches;
  private final Advertised advertised;
  private final BidBook bids;
  private final ViewTally tally = new ViewTally();
  private int sent;
  private double received;
  private double paid;

  /**
   * @param limit most targets the camera may own before it claims no further one; 0 for no limit
   */
  public Agent(int camera, int limit, Links links, Surroundings around) {
    this.camera = camera;
    this.limit = limit;
    this.around = around;
    this.links = links;
    int targets = around.features().length;
    neighbours = new Neighbours(around.cameras().count());
    owned = new OwnedTargets(around.features());
    searches = new Searches(targets);
    advertised = new Advertised(targets);
    bids = new BidBook(targets, around.bidderHash() != null);
  }

  public int camera() {
    return camera;
  }

  public Neighbours neighbours() {
    return neighbours;
  }

  public Links links() {
    return links;
  }

  public OwnedTargets owned() {
    return owned;
  }

  public Searches searches() {
    return searches;
  }

  public Advertised advertised() {
    return advertised;
  }

  public BidBook bids() {
    return bids;
  }

  public ViewTally tally() {
    return tally;
  }

  /** How sure the camera is of a target now; 0 where it does not see it. */
  public double confidence(int target) {
    return around.sightings().confidence(camera, target);
  }

  public boolean sees(int target) {
    return around.sightings().sees(camera, target);
  }

  public boolean online(int other) {
    return around.cameras().online(other);
  }

  /** Whether the camera may claim one more target that nobody owns. */
  public boolean mayClaim(int claimedInThisStep) {
    return limit == 0 || limit > claimedInThisStep + owned.size();
  }

  /** Strength of the link to a camera under its current name: one that is offline has none. */
  public double linkTo(int other, int target) {
    return online(other) ? links.strength(other, target) : Links.NONE;
  }

  /** Whether a message to this camera would arrive. */
  public boolean reaches(int other) {
    return neighbours.contains(other) && online(other);
  }

  /** Sends a message; one to a camera that is out of reach is lost without a trace. */
  public void send(MessageKind kind, int to, int target, double value) {
    if (reaches(to)) {
      around.queue().send(kind, camera, to, target, value);
    }
  }

  /**
   * Asks a neighbour to bid for a target; one that is offline is asked in vain (quirk Q7).
   *
   * @param counted whether the attempt counts as sent
   */
  public void ask(int neighbour, int target, boolean counted) {
    if (counted) {
      sent++;
    }
    if (online(neighbour)) {
      advertised.add(target, neighbour);
    } else {
      advertised.open(target);
    }
    send(MessageKind.START_SEARCH, neighbour, target, 0);
  }

  /** Takes a delivered message. */
  public void receive(MessageKind kind, int from, int target, double value) {
    switch (kind) {
      case START_SEARCH -> {
        if (neighbours.contains(from)) {
          searches.put(target, from);
        }
      }
      case STOP_SEARCH -> stopSearch(target);
      case FOUND -> {
        if (neighbours.contains(from) && advertised.contains(target)) {
          bids.add(target, from, value, bidderHash(from));
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

  private int bidderHash(int bidder) {
    return around.bidderHash() == null ? 0 : around.bidderHash().applyAsInt(bidder);
  }

  /** Notes a price paid for a target. */
  public void pay(double price) {
    paid = around.pricesAddUp() ? paid + price : price;
  }

  /** Notes a price received for a target. */
  public void earn(double price) {
    received += price;
  }

  /** Prices received at the last settlement, less what was paid since the one before it began. */
  public double balance() {
    return received - paid;
  }

  public double received() {
    return received;
  }

  public double paid() {
    return paid;
  }

  /** How many StartSearch messages were attempted since {@link #resetCounters}. */
  public int sent() {
    return sent;
  }

  /** Starts the step's counters anew. */
  public void resetCounters() {
    sent = 0;
    received = 0;
    paid = 0;
  }
}
