package org.hificamsim.core.scenario;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/** Reads the coverage study's list of candidate radii. */
final class ZoomListReader {
  /** The list. */
  static final Element<Scenario> ELEMENT =
      Element.<Scenario>of(
              "zoom", "The radii that every camera can choose from, between spaces, rising, m.")
          .holds("#[" + Type.POSITIVE_LENGTH.schema() + "] minLength=1 maxLength=1000");

  private static final int MAX_LEVELS = 1000;

  private ZoomListReader() {}

  /** The radii, rising; empty where the file has no zoom list. */
  static List<Double> zooms(XmlElement root) {
    List<XmlElement> lists = root.all(ELEMENT.name());
    if (lists.isEmpty()) {
      return List.of();
    }
    if (lists.size() > 1) {
      throw lists.get(1).place().error("a second <zoom>, expected one for all cameras");
    }
    XmlElement list = lists.get(0);
    String text = list.text().strip();
    if (text.isEmpty()) {
      throw list.place().error("<zoom> is empty, expected radii such as 2.5 5.0 7.5");
    }
    List<Double> radii = new ArrayList<>();
    for (String item : text.split("\\s+")) {
      radii.add(radius(list, item, radii));
    }
    if (radii.size() > MAX_LEVELS) {
      throw list.place()
          .error("<zoom> has " + radii.size() + " radii, expected at most " + MAX_LEVELS);
    }
    return radii;
  }

  private static double radius(XmlElement list, String item, List<Double> before) {
    double last = before.isEmpty() ? 0 : before.get(before.size() - 1);
    double radius = radius(list, item);
    if (radius <= last) {
      throw invalid(list, item, "' after " + last + ", expected rising radii, each once");
    }
    return radius;
  }

  private static double radius(XmlElement list, String item) {
    try {
      return Range.POSITIVE_LENGTH.parse(item);
    } catch (IllegalArgumentException e) {
      throw invalid(list, item, "', expected radii above 0 and at most 1e9 (m), between spaces");
    }
  }

  private static InputException invalid(XmlElement list, String item, String problem) {
    String quoted = Place.shortened(item);
    return list.place().error("<zoom> has '" + quoted + problem);
  }
}
