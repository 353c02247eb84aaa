package epics.camsim.core;

import java.util.Collections;
import java.util.List;
import java.util.Random;

/** An object that moves straight or along waypoints, and turns round at the border. */
public class TraceableObject {
  private static final double REACHED_DISTANCE = 1 - 0.00001;

  private final List<Double> features;
  private final List<Point> waypoints;
  private double x;
  private double y;
  private double heading;
  private double speed;
  private int waypoint = 1;

  TraceableObject(double features, Point start, double heading, double speed, List<Point> path) {
    this.features = Collections.singletonList(features);
    this.waypoints = path;
    this.x = start.x;
    this.y = start.y;
    this.heading = heading;
    this.speed = speed;
  }

  /** The x coordinate, in metres. */
  public double getX() {
    return x;
  }

  /** The y coordinate, in metres. */
  public double getY() {
    return y;
  }

  List<Double> getFeatures() {
    return features;
  }

  void move(SimCore world, Random turn) {
    if (!waypoints.isEmpty()) {
      headForWaypoint();
    }
    double dx = Math.sin(heading) * speed;
    double dy = Math.cos(heading) * speed;
    x += dx;
    y += dy;
    if (!world.contains(x, y)) {
      heading += Math.PI + (((turn.nextDouble() * 2 - 1) * Math.PI) / 6);
      x -= dx;
      y -= dy;
    }
  }

  private void headForWaypoint() {
    Point target = waypoints.get(waypoint);
    double dx = x - target.x;
    double dy = y - target.y;
    if (Math.sqrt(dx * dx + dy * dy) < REACHED_DISTANCE) {
      waypoint = (waypoint + 1) % waypoints.size();
      target = waypoints.get(waypoint);
    }
    heading = Math.atan2(1, 0) - Math.atan2(target.y - y, target.x - x);
  }
}
