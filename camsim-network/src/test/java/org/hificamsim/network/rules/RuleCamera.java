package org.hificamsim.network.rules;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.w3c.dom.Element;

/**
 * A camera with the schedule BanditSolverZoom, as sections 6, 8 and 9.6 of docs/camsim-behaviour.md
 * describe it. Messages are nested calls.
 */
final class RuleCamera {
  /** The searcher of an object that nobody owns. */
  static final Object NOBODY = new Object();

  /** The counts of all cameras of a run. */
  static final class Counts {
    long communication;
    long handovers;
  }

  final String name;
  final RuleBandit bandit;
  final List<RuleCamera> neighbours = new ArrayList<>();
  final Map<RuleObject, Double> visible = new LinkedHashMap<>();
  final Map<List<Double>, RuleObject> owned = new HashMap<>();
  final Map<RuleObject, Object> search = new LinkedHashMap<>();
  private final Map<RuleObject, Map<RuleCamera, Double>> bids = new HashMap<>();
  private final Map<RuleObject, Boolean> advertised = new HashMap<>();
  private final Counts counts;
  private final double[] topLeft;
  double x;
  double y;
  double heading;
  double angle;
  double range;
  boolean online = true;
  int sent;
  int tracked;
  double relativeConfidence;

  RuleCamera(Element element, RuleBandit bandit, Counts counts, double[] topLeft) {
    name = element.getAttribute("name");
    this.bandit = bandit;
    this.counts = counts;
    this.topLeft = topLeft;
    double given = RuleXml.number(element, "range");
    x = RuleXml.number(element, "x");
    y = RuleXml.number(element, "y");
    heading = Math.toRadians(RuleXml.number(element, "heading"));
    angle = Math.toRadians(RuleXml.number(element, "viewing_angle"));
    range = given >= 20 ? 16.0 : given;
  }

  /** Applies the attributes of an event; -1 changes nothing (3.5). */
  void change(Element event) {
    x = changed(event, "x", x);
    y = changed(event, "y", y);
    heading = changedAngle(event, "heading", heading);
    angle = changedAngle(event, "viewing_angle", angle);
    if (RuleXml.number(event, "range") != -1) {
      range = RuleXml.number(event, "range");
      bandit.forget();
    }
  }

  private static double changed(Element event, String attribute, double before) {
    double given = RuleXml.number(event, attribute);
    return given == -1 ? before : given;
  }

  private static double changedAngle(Element event, String attribute, double before) {
    double given = RuleXml.number(event, attribute);
    return given == -1 ? before : Math.toRadians(given);
  }

  /** Updates what the camera sees (6.1, 6.2). */
  void look(List<RuleObject> objects) {
    for (RuleObject object : objects) {
      double confidence = confidenceNow(object);
      if (confidence > 0) {
        visible.put(object, confidence);
      } else {
        visible.remove(object);
      }
    }
  }

  private double confidenceNow(RuleObject object) {
    double dx = object.x - x;
    double dy = object.y - y;
    double distance = Math.sqrt(dx * dx + dy * dy);
    double alpha =
        Math.acos(Math.sin(heading) * (dx / distance) + Math.cos(heading) * (dy / distance));
    if (distance > range || !(alpha < angle / 2)) {
      return 0;
    }
    double anglePart = Math.toDegrees(angle) == 360 ? 1 : (angle / 2 - alpha) / (angle / 2);
    return 1 / (distance + ((range - distance) / range)) * anglePart;
  }

  private double confidence(RuleObject object) {
    return visible.getOrDefault(object, 0.0);
  }

  private boolean owns(RuleObject object) {
    return owned.containsKey(object.features);
  }

  /** Step 6: an active schedule broadcasts every owned object (8.3, 8.6). */
  void advertise() {
    for (RuleObject object : owned.values()) {
      search.put(object, this);
      for (RuleCamera neighbour : neighbours) {
        sent++;
        advertised.put(object, true);
        if (neighbour.online) {
          counts.communication++;
          neighbour.startSearch(this, object);
        }
      }
    }
  }

  private void startSearch(RuleCamera from, RuleObject object) {
    if (neighbours.contains(from)) {
      search.put(object, from);
    }
  }

  private void broadcastStop(RuleObject object) {
    for (RuleCamera neighbour : neighbours) {
      if (neighbour.online) {
        neighbour.stopSearch(object);
      }
    }
    advertised.remove(object);
  }

  private void stopSearch(RuleObject object) {
    search.remove(object);
    if (visible.containsKey(object) && !owns(object)) {
      bandit.sharedViews++;
    }
  }

  /** Step 7: looks for searched objects (8.4). */
  void lookForSearched() {
    List<RuleObject> claimed = new ArrayList<>();
    for (RuleObject object : visible.keySet()) {
      Object searcher = search.get(object);
      if (searcher == null || owns(object)) {
        continue;
      }
      if (searcher == NOBODY || searcher == this) {
        owned.put(object.features, object);
        broadcastStop(object);
        claimed.add(object);
      } else if (neighbours.contains(searcher) && ((RuleCamera) searcher).online) {
        ((RuleCamera) searcher).found(this, object, confidence(object));
      }
    }
    claimed.forEach(search::remove);
  }

  private void found(RuleCamera from, RuleObject object, double value) {
    if (neighbours.contains(from) && advertised.containsKey(object)) {
      bids.computeIfAbsent(object, key -> new HashMap<>()).putIfAbsent(from, value);
    }
  }

  /** Step 8b: settles auctions, then measures and learns (8.5, 10.4, 9.6). */
  void update() {
    sent = 0;
    List<RuleObject> settled = new ArrayList<>();
    List<RuleObject> auctions =
        search.entrySet().stream()
            .filter(entry -> entry.getValue() == this)
            .map(Map.Entry::getKey)
            .toList();
    for (RuleObject object : auctions) {
      if (settle(object)) {
        settled.add(object);
      }
    }
    settled.forEach(search::remove);
    measure();
    range = bandit.learn(owned.size(), tracked, range);
  }

  private boolean settle(RuleObject object) {
    Map<RuleCamera, Double> offers = bids.remove(object);
    boolean seen = visible.containsKey(object);
    if (offers == null) {
      bandit.privateViews += seen ? 1 : 0;
      return false;
    }
    RuleCamera winner = this;
    double highest = confidence(object);
    for (Map.Entry<RuleCamera, Double> offer : offers.entrySet()) {
      if (offer.getKey().online && offer.getValue() > highest) {
        highest = offer.getValue();
        winner = offer.getKey();
      }
    }
    if (winner == this) {
      bandit.sharedViews += offers.size() > 1 && seen ? 1 : 0;
    } else {
      handOver(object, winner);
      bandit.sharedViews += seen ? 1 : 0;
      bandit.theirViews += seen ? 0 : 1;
    }
    broadcastStop(object);
    return true;
  }

  private void handOver(RuleObject object, RuleCamera winner) {
    counts.handovers++;
    winner.owned.put(object.features, object);
    winner.search.remove(object);
    owned.remove(object.features);
  }

  private double rangeFactor() {
    return 0.95 * (1 - range / 20) - 0.15;
  }

  /** The utility (10.3). */
  double utility() {
    double factor = Math.max(rangeFactor(), 0);
    double utility = 0.0;
    for (RuleObject object : owned.values()) {
      utility += confidence(object) * factor;
    }
    return utility;
  }

  /** Counts the objects tracked, and their relative confidence (10.4). */
  private void measure() {
    double sum = 0.0;
    tracked = 0;
    Map<List<Double>, RuleObject> copy = new HashMap<>();
    owned.forEach(copy::put);
    for (RuleObject object : copy.values()) {
      if (visible.containsKey(object)) {
        sum += Math.max(0, (1 - distanceFromTopLeft(object) / 20) * rangeFactor());
        tracked++;
      }
    }
    relativeConfidence = sum == 0 ? 0 : sum / tracked;
  }

  private double distanceFromTopLeft(RuleObject object) {
    double dx = (object.x - topLeft[0]) - (x - topLeft[0]);
    double dy = (topLeft[1] + object.y) * -1 - (topLeft[1] + y) * -1;
    return Math.sqrt(dx * dx + dy * dy);
  }

  /** The overlap with a camera later in the list (10.2). */
  double overlap(RuleCamera other) {
    double[] first = {x - topLeft[0], (topLeft[1] + y) * -1};
    double[] second = {other.x - topLeft[0], (topLeft[1] + other.y) * -1};
    return RuleOverlap.area(first, range, second, other.range);
  }

  /** The hash of section 4.5, by which bids are ordered. */
  @Override
  public int hashCode() {
    String text =
        "<camera ai_algorithm=\"epics.ai.dynamicZoom.BanditSolverZoom\" heading=\""
            + Math.toDegrees(heading)
            + "\" name=\""
            + name
            + "\" range=\""
            + range
            + "\" viewing_angle=\""
            + Math.toDegrees(angle)
            + "\" x=\""
            + x
            + "\" y=\""
            + y
            + "\" comm=\"0\"/> visibleObjects="
            + visible.size()
            + " neighbours="
            + neighbours.size();
    return text.hashCode();
  }

  @Override
  public boolean equals(Object other) {
    return this == other;
  }
}
