package org.hificamsim.network.rules;

import java.util.List;
import java.util.Random;
import org.w3c.dom.Element;

/** An object that moves by section 5 of docs/camsim-behaviour.md. */
final class RuleObject {
  /** The borders of the field. */
  record Border(double minX, double maxX, double minY, double maxY) {
    boolean isLeftBy(RuleObject object) {
      return object.x > maxX || object.x < minX || object.y > maxY || object.y < minY;
    }
  }

  /** The key of CamSim's maps of objects (4.4). */
  final List<Double> features;

  private final String move;
  private final double mean;
  private final double deviation;
  private final List<Element> waypoints;
  double x;
  double y;
  private double heading;
  private double speed;
  private int target = 1;

  /** Reads an {@code object} or {@code object_with_waypoints} of a scenario file (3.3, 3.4). */
  static RuleObject inFile(Element element) {
    boolean path = element.getTagName().equals("object_with_waypoints");
    String move = path ? "epics.movement.Waypoints" : element.getAttribute("move");
    return new RuleObject(element, "features", move.isEmpty() ? "epics.movement.Straight" : move);
  }

  /** Reads an event that adds an object (3.5). */
  static RuleObject added(Element event) {
    boolean path = RuleXml.children(event, "waypoint").size() > 0;
    return new RuleObject(event, "name", path ? "event path" : "epics.movement.Straight");
  }

  private RuleObject(Element element, String nameAttribute, String move) {
    this.move = move;
    features = List.of(RuleXml.number(element, nameAttribute));
    mean = RuleXml.numberOr(element, "mean", 0);
    deviation = RuleXml.numberOr(element, "std", 1);
    waypoints = RuleXml.children(element, "waypoint");
    speed = RuleXml.number(element, "speed");
    boolean path = element.getTagName().equals("object_with_waypoints");
    heading = Math.toRadians(path ? -1 : RuleXml.number(element, "heading"));
    boolean startsOnPath = path || move.equals("event path");
    Element start = startsOnPath ? waypoints.get(0) : element;
    x = RuleXml.number(start, "x");
    y = RuleXml.number(start, "y");
    if (move.equals("epics.movement.Waypoints")) { // quirk Q3
      speed = heading;
    }
  }

  void move(Random gauss, Random turn, Border border) {
    double dx;
    double dy;
    if (move.endsWith(".Brownian")) {
      dx = mean + gauss.nextGaussian() * deviation;
      dy = mean + gauss.nextGaussian() * deviation;
    } else {
      if (move.endsWith(".DirectedBrownian")) {
        speed += gauss.nextGaussian() / 10;
        heading += gauss.nextGaussian() / 2;
      } else if (!move.endsWith(".Straight")) {
        faceWaypoint();
      }
      dx = Math.sin(heading) * speed;
      dy = Math.cos(heading) * speed;
    }
    x += dx;
    y += dy;
    if (border.isLeftBy(this)) {
      heading += Math.PI + (((turn.nextDouble() * 2 - 1) * Math.PI) / 6);
      x -= dx;
      y -= dy;
    }
  }

  private void faceWaypoint() {
    double ex = x - RuleXml.number(waypoints.get(target), "x");
    double ey = y - RuleXml.number(waypoints.get(target), "y");
    if (Math.sqrt(ex * ex + ey * ey) < 1 - 0.00001) {
      target = (target + 1) % waypoints.size();
    }
    double toX = RuleXml.number(waypoints.get(target), "x") - x;
    double toY = RuleXml.number(waypoints.get(target), "y") - y;
    heading = Math.atan2(1, 0) - Math.atan2(toY, toX);
  }
}
