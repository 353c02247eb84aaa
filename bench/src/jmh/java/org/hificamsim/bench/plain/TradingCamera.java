package org.hificamsim.bench.plain;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.hificamsim.core.scenario.spec.CameraSpec;

/**
 * A camera that owns targets and sells them as in CamSim: it advertises to all others the targets
 * that it is about to lose (schedule Passive, policy Broadcast; behaviour 6 and 8).
 */
final class TradingCamera {

  /** The confidence below which a target is about to be lost. */
  private static final double LOSING = 0.1;

  private static final double DECAY = 0.995;
  private static final double MAX_RANGE = 20;

  private final double x;
  private final double y;
  private final double heading;
  private final double angle;
  private final boolean allRound;
  private final double range;
  private List<TradingCamera> neighbours = List.of();

  private final Map<Target, Double> visible = new LinkedHashMap<>();
  private final Set<Target> owned = new LinkedHashSet<>();

  /** The camera that searches for each target; null if nobody has owned the target yet. */
  private final Map<Target, TradingCamera> searched = new LinkedHashMap<>();

  private final Set<Target> advertised = new LinkedHashSet<>();
  private final Map<Target, Map<TradingCamera, Double>> bids = new HashMap<>();
  private final Map<Target, Double> last = new HashMap<>();
  private final Map<TradingCamera, Double> links = new HashMap<>();
  private int sent;
  private int handovers;

  TradingCamera(CameraSpec spec) {
    x = spec.x();
    y = spec.y();
    heading = Math.toRadians(spec.heading());
    angle = Math.toRadians(spec.viewingAngle());
    allRound = spec.viewingAngle() == 360;
    range = spec.range();
  }

  void meet(List<TradingCamera> others, List<Target> targets) {
    neighbours = others.stream().filter(other -> other != this).toList();
    targets.forEach(target -> searched.put(target, null));
  }

  void observe(List<Target> targets) {
    for (Target target : targets) {
      double confidence = confidence(target);
      if (confidence > 0) {
        visible.put(target, confidence);
      } else {
        visible.remove(target);
      }
    }
  }

  private double confidence(Target target) {
    double dx = target.x() - x;
    double dy = target.y() - y;
    double distance = Math.sqrt(dx * dx + dy * dy);
    if (distance > range) {
      return 0;
    }
    double cosOffAxis = Math.sin(heading) * (dx / distance) + Math.cos(heading) * (dy / distance);
    double off = Math.acos(cosOffAxis);
    if (!(off < angle / 2)) {
      return 0;
    }
    double near = 1 / (distance + (range - distance) / range);
    return allRound ? near : near * ((angle / 2 - off) / (angle / 2));
  }

  private double value(Target target) {
    return visible.getOrDefault(target, 0.0);
  }

  void advertise() {
    sent = 0;
    handovers = 0;
    for (Target target : owned) {
      double now = value(target);
      if (now < LOSING && (now == 0 || now < last.getOrDefault(target, 0.0))) {
        searched.put(target, this);
        advertised.add(target);
        for (TradingCamera neighbour : neighbours) {
          neighbour.searched.put(target, this);
          sent++;
        }
      }
      last.put(target, now);
    }
  }

  void look() {
    for (Target target : visible.keySet()) {
      if (!owned.contains(target) && searched.containsKey(target)) {
        TradingCamera searcher = searched.get(target);
        if (searcher == null) {
          own(target);
          stopSearch(target);
        } else {
          searcher.found(target, this, value(target));
        }
      }
    }
  }

  private void own(Target target) {
    owned.add(target);
    searched.remove(target);
  }

  private void found(Target target, TradingCamera bidder, double value) {
    if (advertised.contains(target)) {
      bids.computeIfAbsent(target, key -> new LinkedHashMap<>()).putIfAbsent(bidder, value);
    }
  }

  private void stopSearch(Target target) {
    advertised.remove(target);
    for (TradingCamera neighbour : neighbours) {
      neighbour.searched.remove(target);
    }
  }

  void settle() {
    links.replaceAll((camera, strength) -> strength * DECAY);
    for (Target target : List.copyOf(searched.keySet())) {
      if (searched.get(target) == this) {
        settle(target, bids.remove(target));
      }
    }
  }

  private void settle(Target target, Map<TradingCamera, Double> offers) {
    if (offers == null) {
      return;
    }
    TradingCamera winner = this;
    double highest = value(target);
    for (Map.Entry<TradingCamera, Double> offer : offers.entrySet()) {
      if (offer.getValue() > highest) {
        highest = offer.getValue();
        winner = offer.getKey();
      }
    }
    searched.remove(target);
    if (winner != this) {
      owned.remove(target);
      winner.own(target);
      links.merge(winner, 1.0, Double::sum);
      handovers++;
    }
    stopSearch(target);
  }

  int sent() {
    return sent;
  }

  int handovers() {
    return handovers;
  }

  double utility() {
    double sum = 0;
    for (Target target : owned) {
      sum += value(target) * Math.max(0, worth());
    }
    return sum;
  }

  private double worth() {
    return 0.95 * (1 - range / MAX_RANGE) - 0.15;
  }

  /** The number of targets that it owns and sees. */
  int tracked() {
    int tracked = 0;
    for (Target target : owned) {
      tracked += visible.containsKey(target) ? 1 : 0;
    }
    return tracked;
  }

  /** The mean relative confidence of the tracked targets. */
  double relativeConfidence() {
    double sum = 0;
    for (Target target : owned) {
      if (visible.containsKey(target)) {
        double distance = Math.hypot(target.x() - x, target.y() - y);
        sum += Math.max(0, (1 - distance / MAX_RANGE) * worth());
      }
    }
    return sum == 0 ? 0 : sum / tracked();
  }
}
