package epics.camsim.core;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** A camera: what it sees, and how it trades objects by an active schedule that broadcasts. */
public class CameraController {
  /** The greatest range that CamSim's own zoom gives, in metres. */
  public static final double MAX_VISIBILITY = 20;

  private final String name;
  private double x;
  private double y;
  private double heading;
  private double angle;
  private double range;
  private boolean offline;
  private final Map<TraceableObject, Double> visible = new LinkedHashMap<>();
  private final List<CameraController> neighbours = new ArrayList<>();
  private final Map<List<Double>, TraceableObject> owned = new HashMap<>();
  private final Map<TraceableObject, CameraController> search = new LinkedHashMap<>();
  private final Set<TraceableObject> advertised = new LinkedHashSet<>();
  private final Map<TraceableObject, Map<CameraController, Double>> bids = new HashMap<>();
  private int sent;

  CameraController(String name, double x, double y, double heading, double angle, double range) {
    this.name = name;
    this.x = x;
    this.y = y;
    this.heading = heading;
    this.angle = angle;
    this.range = clamped(range);
  }

  private static double clamped(double range) {
    return range >= MAX_VISIBILITY ? MAX_VISIBILITY - MAX_VISIBILITY * 0.2 : range;
  }

  /** The x coordinate, in metres. */
  public double getX() {
    return x;
  }

  /** The y coordinate, in metres. */
  public double getY() {
    return y;
  }

  /** The heading, in radians. */
  public double getHeading() {
    return heading;
  }

  /** The opening angle, in radians. */
  public double getAngle() {
    return angle;
  }

  /** The range, in metres. */
  public double getRange() {
    return range;
  }

  /** The greatest range, in metres. */
  public double getMaxRange() {
    return MAX_VISIBILITY;
  }

  /** Whether an event has switched the camera off. */
  public boolean isOffline() {
    return offline;
  }

  /** The name of the camera; {@code Offline} while it is offline. */
  public String getName() {
    return offline ? "Offline" : name;
  }

  /** Zooms as CamSim itself does. */
  public void increaseRange(double metres) {
    range = clamped(range + metres);
  }

  /** Sets position, aim and range in metres and degrees; -1 leaves a value unchanged. */
  public void change(double newX, double newY, double newHeading, double newAngle, double reach) {
    x = newX == -1 ? x : newX;
    y = newY == -1 ? y : newY;
    heading = newHeading == -1 ? heading : Math.toRadians(newHeading);
    angle = newAngle == -1 ? angle : Math.toRadians(newAngle);
    range = reach == -1 ? range : reach;
  }

  /** Looks at an object; the name is misspelt as CamSim's is. */
  public double update_visiblity(TraceableObject object) {
    double confidence = confidence(object);
    if (confidence > 0) {
      addVisibleObject(object, confidence);
    } else {
      removeVisibleObject(object);
    }
    return confidence;
  }

  private double confidence(TraceableObject object) {
    double dx = object.getX() - x;
    double dy = object.getY() - y;
    double distance = Math.sqrt(dx * dx + dy * dy);
    if (distance > range) {
      return 0;
    }
    double along = Math.sin(heading) * (dx / distance) + Math.cos(heading) * (dy / distance);
    double offAxis = Math.acos(along);
    double half = angle / 2;
    if (!(offAxis < half)) {
      return 0;
    }
    double near = 1 / (distance + ((range - distance) / range));
    return near * (Math.toDegrees(angle) == 360 ? 1 : (half - offAxis) / half);
  }

  private void addVisibleObject(TraceableObject object, double confidence) {
    visible.put(object, confidence);
  }

  private void removeVisibleObject(TraceableObject object) {
    visible.remove(object);
  }

  /** The objects that the camera sees, with their confidences. */
  Map<TraceableObject, Double> visible() {
    return visible;
  }

  void meet(CameraController other) {
    neighbours.add(other);
  }

  void switchOff() {
    offline = true;
  }

  void announce(TraceableObject object) {
    search.put(object, null);
  }

  void forget(TraceableObject object) {
    visible.remove(object);
  }

  int sent() {
    return sent;
  }

  /** Advertises all owned objects; returns how many messages arrived. */
  int advertise() {
    int delivered = 0;
    for (TraceableObject object : owned.values()) {
      search.put(object, this);
      advertised.add(object);
      for (CameraController neighbour : neighbours) {
        sent++;
        if (!neighbour.offline) {
          neighbour.search.put(object, this);
          delivered++;
        }
      }
    }
    return delivered;
  }

  /** Claims visible objects that nobody owns, and bids for those that others advertise. */
  void lookForSearched() {
    List<TraceableObject> claimed = new ArrayList<>();
    for (Map.Entry<TraceableObject, Double> seen : visible.entrySet()) {
      TraceableObject object = seen.getKey();
      if (owned.containsKey(object.getFeatures()) || !search.containsKey(object)) {
        continue;
      }
      CameraController searcher = search.get(object);
      if (searcher == null) {
        owned.put(object.getFeatures(), object);
        stopSearch(object);
        claimed.add(object);
      } else if (!searcher.offline && searcher.advertised.contains(object)) {
        searcher
            .bids
            .computeIfAbsent(object, key -> new LinkedHashMap<>())
            .putIfAbsent(this, seen.getValue());
      }
    }
    search.keySet().removeAll(claimed);
  }

  private void stopSearch(TraceableObject object) {
    for (CameraController neighbour : neighbours) {
      if (!neighbour.offline) {
        neighbour.search.remove(object);
      }
    }
    advertised.remove(object);
  }

  /** Settles the auctions of this step; returns how many objects were handed over. */
  int settle() {
    sent = 0;
    int handovers = 0;
    List<TraceableObject> settled = new ArrayList<>();
    for (Map.Entry<TraceableObject, CameraController> entry : search.entrySet()) {
      TraceableObject object = entry.getKey();
      Map<CameraController, Double> offers = bids.remove(object);
      if (entry.getValue() != this || offers == null) {
        continue;
      }
      CameraController winner = winner(object, offers);
      if (winner != this) {
        winner.owned.put(object.getFeatures(), object);
        winner.search.remove(object);
        owned.remove(object.getFeatures());
        handovers++;
      }
      stopSearch(object);
      settled.add(object);
    }
    search.keySet().removeAll(settled);
    return handovers;
  }

  private CameraController winner(TraceableObject object, Map<CameraController, Double> offers) {
    CameraController winner = this;
    double best = visible.getOrDefault(object, 0.0);
    for (Map.Entry<CameraController, Double> offer : offers.entrySet()) {
      if (!offer.getKey().offline && offer.getValue() > best) {
        best = offer.getValue();
        winner = offer.getKey();
      }
    }
    return winner;
  }

  private double closeness() {
    return 0.95 * (1 - range / MAX_VISIBILITY) - 0.15;
  }

  double utility() {
    double worth = Math.max(0, closeness());
    double sum = 0;
    for (TraceableObject object : owned.values()) {
      sum += visible.getOrDefault(object, 0.0) * worth;
    }
    return sum;
  }

  /** The owned objects that the camera sees. */
  List<TraceableObject> tracked() {
    List<TraceableObject> tracked = new ArrayList<>();
    for (TraceableObject object : new HashMap<>(owned).values()) {
      if (visible.containsKey(object)) {
        tracked.add(object);
      }
    }
    return tracked;
  }

  /** The mean certainty of the tracked objects. */
  double certainty(SimCore world) {
    double sum = 0;
    List<TraceableObject> tracked = tracked();
    for (TraceableObject object : tracked) {
      double dx = (object.getX() - world.get_min_x()) - left(world);
      double dy = world.distanceFromTop(object.getY()) - top(world);
      double distance = Math.sqrt(dx * dx + dy * dy);
      sum += Math.max(0, (1 - distance / MAX_VISIBILITY) * closeness());
    }
    return sum == 0 ? 0 : sum / tracked.size();
  }

  double left(SimCore world) {
    return x - world.get_min_x();
  }

  double top(SimCore world) {
    return world.distanceFromTop(y);
  }
}
