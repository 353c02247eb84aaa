package org.hificamsim.tracks;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Field;

/** What a recording has in it: extent in time and place, speeds, gaps, and what is odd. */
final class Findings {
  private final double interval;
  private final Obstacles obstacles;
  private final Speeds speeds = new Speeds();
  private final Jumps jumps = new Jumps();
  private long samples;
  private int targets;
  private int gaps;
  private double longestGap;
  private double end;
  private double minX = Double.POSITIVE_INFINITY;
  private double maxX = Double.NEGATIVE_INFINITY;
  private double minY = Double.POSITIVE_INFINITY;
  private double maxY = Double.NEGATIVE_INFINITY;
  private TargetRecord last;
  private long ofLast;
  private int single;
  private long blocked; // ways between two samples
  private String firstBlocked = "";

  /**
   * @param interval between most samples of a target, seconds
   * @param obstacles through which nobody should go
   */
  Findings(double interval, Obstacles obstacles) {
    this.interval = interval;
    this.obstacles = obstacles;
  }

  void sample(TargetRecord target, double time, double x, double y) {
    if (target != last) {
      endTarget();
      targets++;
      last = target;
    }
    samples++;
    ofLast++;
    end = Math.max(end, time);
    minX = Math.min(minX, x);
    maxX = Math.max(maxX, x);
    minY = Math.min(minY, y);
    maxY = Math.max(maxY, y);
  }

  private void endTarget() {
    single += ofLast == 1 ? 1 : 0;
    ofLast = 0;
  }

  /** A way between two samples of a target, which ends at this time. */
  void leg(TargetRecord target, double time, double duration, Point from, Point to) {
    double way = Math.hypot(to.x() - from.x(), to.y() - from.y());
    if (!obstacles.isEmpty()
        && !obstacles.clear(from.x(), from.y(), to.x(), to.y())
        && blocked++ == 0) {
      firstBlocked = "target " + target.name() + " at " + time + " s";
    }
    double speed = way / duration;
    speeds.add(speed);
    jumps.add(new Jumps.Leg(target.name(), time, way, speed));
  }

  /** Another track begins. */
  void track() {
    jumps.endTrack();
  }

  void gap(double duration) {
    gaps++;
    longestGap = Math.max(longestGap, duration);
  }

  /** Between most samples of a target, seconds. */
  double interval() {
    return interval;
  }

  long samples() {
    return samples;
  }

  int targets() {
    return targets;
  }

  int gaps() {
    return gaps;
  }

  /** Seconds. */
  double longestGap() {
    return longestGap;
  }

  /** From step 0 to the last sample, seconds. */
  double duration() {
    return end;
  }

  /** Of the way between two samples, metres a second. */
  double speed(double part) {
    return speeds.quantile(part);
  }

  /** What holds all samples. */
  Field box() {
    return new Field(minX, maxX, minY, maxY);
  }

  /** What is odd, in lines. */
  List<String> odd() {
    endTarget();
    last = null;
    jumps.endTrack();
    List<String> odd = new ArrayList<>(jumps.lines(speeds.quantile(0.75)));
    if (single > 0) {
      odd.add(single + " targets with one sample alone");
    }
    if (blocked > 0) {
      odd.add(
          "through a wall: "
              + (blocked == 1 ? "once, " : blocked + " times, first ")
              + firstBlocked);
    }
    return odd;
  }
}
