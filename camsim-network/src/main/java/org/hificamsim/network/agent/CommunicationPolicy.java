package org.hificamsim.network.agent;

import java.util.BitSet;
import java.util.List;
import java.util.Locale;

/**
 * Which cameras a camera asks to bid when it advertises a target, in the order of CamSim's numbers
 * (behaviour 8.6).
 */
public enum CommunicationPolicy implements Named {
  /** Asks every neighbour. */
  BROADCAST,
  /**
   * Asks each neighbour with probability (1 + its link) / (1 + the strongest link); all if the draw
   * selects none.
   */
  SMOOTH,
  /**
   * Asks each neighbour with its link as the probability, or 0.1 without a link; all if the draw
   * selects none.
   */
  STEP,
  /** Asks every linked name; these messages are not counted as attempts. */
  FIX;

  private static final double CHANCE_WITHOUT_LINK = 0.1;

  @Override
  public List<String> names() {
    String name = name().charAt(0) + name().substring(1).toLowerCase(Locale.ROOT);
    return List.of(name, "epics.ai.commpolicy." + name, "epics.commpolicy." + name);
  }

  /** Asks cameras to bid for a target. */
  void startSearch(Contacts contacts, int target) {
    switch (this) {
      case BROADCAST -> contacts.askNeighbours(target);
      case SMOOTH -> {
        double strongest = contacts.links.strongest(target);
        if (strongest == 0) {
          contacts.askNeighboursAsFallback(target);
        } else {
          askSome(contacts, target, strongest);
        }
      }
      case STEP -> askSome(contacts, target, 0);
      case FIX -> askLinked(contacts, target);
    }
  }

  /** Informs the cameras that were asked that a target is no longer for sale. */
  void stopSearch(Contacts contacts, int target) {
    switch (this) {
      case BROADCAST -> contacts.sendToNeighbours(MessageKind.STOP_SEARCH, target);
      case FIX -> sendStopSearch(contacts, contacts.links.linked(), target);
      case SMOOTH, STEP -> {
        if (!contacts.advertises()) {
          contacts.sendToNeighbours(MessageKind.STOP_SEARCH, target);
        } else if (contacts.asked(target) != null) {
          sendStopSearch(contacts, contacts.asked(target), target);
        }
      }
    }
    contacts.withdraw(target);
  }

  /** Asks the neighbours whose probability exceeds one draw; all neighbours if there are none. */
  private void askSome(Contacts contacts, int target, double strongest) {
    double draw = contacts.draw();
    boolean askedSomebody = false;
    BitSet neighbours = contacts.neighbours;
    for (int camera = neighbours.nextSetBit(0);
        camera >= 0;
        camera = neighbours.nextSetBit(camera + 1)) {
      if (chance(contacts.linkTo(camera, target), strongest) > draw) {
        contacts.ask(camera, target);
        askedSomebody = true;
      }
    }
    if (!askedSomebody) {
      contacts.askNeighboursAsFallback(target);
    }
  }

  private double chance(double link, double strongest) {
    if (this == SMOOTH) {
      return (1 + Math.max(link, 0)) / (1 + strongest);
    }
    return link == Links.NONE ? CHANCE_WITHOUT_LINK : link;
  }

  private static void askLinked(Contacts contacts, int target) {
    contacts.withdraw(target);
    contacts.advertise(target);
    BitSet linked = contacts.links.linked();
    for (int name = linked.nextSetBit(0); name >= 0; name = linked.nextSetBit(name + 1)) {
      contacts.asked(target).set(name);
      contacts.send(MessageKind.START_SEARCH, name, target, 0);
    }
  }

  private static void sendStopSearch(Contacts contacts, BitSet names, int target) {
    for (int name = names.nextSetBit(0); name >= 0; name = names.nextSetBit(name + 1)) {
      contacts.send(MessageKind.STOP_SEARCH, name, target, 0);
    }
  }
}
