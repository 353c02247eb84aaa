package org.hificamsim.core.scenario;

import java.util.ArrayList;
import java.util.List;
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
    return root.only(ELEMENT.name(), "one for all cameras")
        .map(ZoomListReader::radii)
        .orElse(List.of());
  }

  private static List<Double> radii(XmlElement list) {
    String text = list.text().strip();
    if (text.isEmpty()) {
      throw list.place().error("<zoom> is empty, expected radii such as 2.5 5.0 7.5");
    }
    List<Double> radii = new ArrayList<>();
    double last = 0;
    for (String item : text.split("\\s+")) {
      last = radius(list, item, last);
      radii.add(last);
    }
    if (radii.size() > MAX_LEVELS) {
      throw list.place()
          .error("<zoom> has " + radii.size() + " radii, expected at most " + MAX_LEVELS);
    }
    return radii;
  }

  private static double radius(XmlElement list, String item, double last) {
    String expected = "', expected radii above 0 and at most 1e9 (m), between spaces";
    try {
      double radius = Range.POSITIVE_LENGTH.parse(item);
      if (radius > last) {
        return radius;
      }
      expected = "' after " + last + ", expected rising radii, each once";
    } catch (IllegalArgumentException e) {
      // reported below
    }
    throw list.place().error("<zoom> has '" + Place.shortened(item) + expected);
  }
}
