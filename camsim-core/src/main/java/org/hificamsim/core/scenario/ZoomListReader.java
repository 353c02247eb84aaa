package org.hificamsim.core.scenario;

import java.util.ArrayList;
import java.util.List;

/** Reads the coverage study's list of candidate radii. */
final class ZoomListReader {
  private static final int MAX_LEVELS = 1000;

  private final XmlElement root;

  ZoomListReader(XmlElement root) {
    this.root = root;
  }

  /** The radii, rising; empty where the file has no zoom list. */
  List<Double> zooms() {
    List<XmlElement> lists = root.all("zoom");
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
      double radius = radius(list, item);
      if (!radii.isEmpty() && radius <= radii.get(radii.size() - 1)) {
        throw list.place()
            .error(
                "<zoom> has '"
                    + XmlText.shortened(item, Attributes.MAX_QUOTED)
                    + "' after "
                    + radii.get(radii.size() - 1)
                    + ", expected rising radii, each once");
      }
      radii.add(radius);
    }
    if (radii.size() > MAX_LEVELS) {
      throw list.place()
          .error("<zoom> has " + radii.size() + " radii, expected at most " + MAX_LEVELS);
    }
    return radii;
  }

  private static double radius(XmlElement list, String item) {
    try {
      double radius = Double.parseDouble(item);
      if (Range.POSITIVE_LENGTH.contains(radius)) {
        return radius;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw list.place()
        .error(
            "<zoom> has '"
                + XmlText.shortened(item, Attributes.MAX_QUOTED)
                + "', expected radii above 0 and at most 1e9 (m), between spaces");
  }
}
