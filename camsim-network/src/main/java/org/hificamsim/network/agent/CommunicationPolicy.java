package org.hificamsim.network.agent;

import java.util.List;
import java.util.Locale;

/**
 * Whom a camera asks when it advertises a target, in the order of CamSim's numbers (behaviour 8.6).
 */
public enum CommunicationPolicy implements Named {
  /** Asks every neighbour. */
  BROADCAST,
  /** Asks a neighbour with probability (1 + its link) / (1 + the strongest link), or else all. */
  SMOOTH,
  /** Asks a neighbour with its link as probability, without a link with 0.1, or else all. */
  STEP,
  /** Asks every name linked to, and counts nothing as sent. */
  FIX;

  private static final double CHANCE_WITHOUT_LINK = 0.1;

  @Override
  public List<String> names() {
    String name = name().charAt(0) + name().substring(1).toLowerCase(Locale.ROOT);
    return List.of(name, "epics.ai.commpolicy." + name, "epics.commpolicy." + name);
  }

  /** Asks cameras to bid for a target. */
  void startSearch(Agent agent, int target) {
    switch (this) {
      case BROADCAST -> askAll(agent, target, true);
      case SMOOTH -> {
        double strongest = agent.links.strongest(target);
        if (strongest == 0) {
          askAll(agent, target, agent.countsFallback());
        } else {
          askSome(agent, target, strongest);
        }
      }
      case STEP -> askSome(agent, target, 0);
      case FIX -> askLinked(agent, target);
    }
  }

  /** Tells those that were asked that a target is no longer for sale. */
  void stopSearch(Agent agent, int target) {
    switch (this) {
      case BROADCAST -> tellAll(agent, target);
      case FIX -> tell(agent, agent.links.linked(), target);
      case SMOOTH, STEP -> {
        if (agent.advertised.isEmpty()) {
          tellAll(agent, target);
        } else if (agent.advertised.contains(target)) {
          tellAsked(agent, target);
        }
      }
    }
    agent.advertised.close(target);
  }

  private static void askAll(Agent agent, int target, boolean counted) {
    if (agent.reachesAll()) {
      agent.askAll(target, counted);
    } else {
      askEach(agent, target, counted);
    }
  }

  private static void askEach(Agent agent, int target, boolean counted) {
    InsertionOrder all = agent.neighbours;
    for (int camera = all.first(); camera != InsertionOrder.END; camera = all.next(camera)) {
      agent.ask(camera, target, counted);
    }
  }

  /** Asks the neighbours whose chance is above one draw, or all where there are none. */
  private void askSome(Agent agent, int target, double strongest) {
    double draw = agent.draw();
    boolean any = false;
    InsertionOrder all = agent.neighbours;
    for (int camera = all.first(); camera != InsertionOrder.END; camera = all.next(camera)) {
      if (chance(agent.linkTo(camera, target), strongest) > draw) {
        agent.ask(camera, target, true);
        any = true;
      }
    }
    if (!any) {
      askAll(agent, target, agent.countsFallback());
    }
  }

  private double chance(double link, double strongest) {
    if (this == SMOOTH) {
      return (1 + Math.max(link, 0)) / (1 + strongest);
    }
    return link == Links.NONE ? CHANCE_WITHOUT_LINK : link;
  }

  private static void askLinked(Agent agent, int target) {
    agent.advertised.close(target);
    agent.advertised.open(target);
    InsertionOrder linked = agent.links.linked();
    for (int name = linked.first(); name != InsertionOrder.END; name = linked.next(name)) {
      agent.advertised.add(target, name);
      agent.startSearch(name, target);
    }
  }

  private static void tellAll(Agent agent, int target) {
    if (agent.reachesAll()) {
      agent.sendToAll(MessageKind.STOP_SEARCH, target, 0);
    } else {
      tell(agent, agent.neighbours, target);
    }
  }

  private static void tell(Agent agent, InsertionOrder names, int target) {
    for (int name = names.first(); name != InsertionOrder.END; name = names.next(name)) {
      agent.send(MessageKind.STOP_SEARCH, name, target, 0);
    }
  }

  private static void tellAsked(Agent agent, int target) {
    Advertised advertised = agent.advertised;
    int camera = advertised.nextAsked(target, 0);
    while (camera >= 0) {
      agent.send(MessageKind.STOP_SEARCH, camera, target, 0);
      camera = advertised.nextAsked(target, camera + 1);
    }
  }
}
