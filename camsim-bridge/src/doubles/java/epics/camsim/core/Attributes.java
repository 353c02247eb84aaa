package epics.camsim.core;

import java.util.ArrayList;
import java.util.List;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** The attributes of an element of a scenario file. */
final class Attributes {
  private final Element element;

  Attributes(Element element) {
    this.element = element;
  }

  static List<Attributes> all(Element root, String tag) {
    List<Attributes> found = new ArrayList<>();
    NodeList nodes = root.getElementsByTagName(tag);
    for (int i = 0; i < nodes.getLength(); i++) {
      found.add(new Attributes((Element) nodes.item(i)));
    }
    return found;
  }

  String text(String name) {
    return element.getAttribute(name);
  }

  boolean has(String name) {
    return element.hasAttribute(name);
  }

  double number(String name) {
    return Double.parseDouble(text(name));
  }

  int integer(String name) {
    return Integer.parseInt(text(name));
  }

  List<Point> waypoints() {
    List<Point> places = new ArrayList<>();
    for (Attributes waypoint : all(element, "waypoint")) {
      places.add(new Point(waypoint.number("x"), waypoint.number("y")));
    }
    return places;
  }
}
