package org.hificamsim.tracks.place;

import java.awt.geom.AffineTransform;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.Place;

/** The pairs of an entity of a DXF. */
final class DxfFields {
  /** The codes that can repeat within an entity, such as the corners of a polyline. */
  private static final int MAX_VALUES = 2_000_000;

  private final String type;
  private final Place place;
  private final List<Integer> codes = new ArrayList<>();
  private final List<Double> numbers = new ArrayList<>();
  private String layer = "0";
  private String name = "";
  private String handle = "";

  private DxfFields(String type, Place place) {
    this.type = type;
    this.place = place;
  }

  /** Reads the entity that the current pair begins; the pair behind it comes next. */
  static DxfFields read(DxfTags tags) {
    DxfFields fields = new DxfFields(tags.value(), tags.place());
    for (tags.next(); tags.code() != 0; tags.next()) {
      fields.add(tags);
    }
    tags.hold();
    return fields;
  }

  private void add(DxfTags tags) {
    int code = tags.code();
    if (code == 8) {
      layer = tags.name();
    } else if (code == 2) {
      name = tags.name();
    } else if (code == 5) {
      handle = tags.value();
    } else if (isNumber(code)) {
      if (numbers.size() == MAX_VALUES) {
        throw tags.place().error("%s has too many points, expected fewer", type);
      }
      codes.add(code);
      numbers.add(tags.number());
    }
  }

  private static boolean isNumber(int code) {
    return (code >= 10 && code < 80) || (code >= 210 && code <= 230);
  }

  String type() {
    return type;
  }

  Place place() {
    return place;
  }

  String layer() {
    return layer;
  }

  /** The name of a block or layer. */
  String name() {
    return name;
  }

  String handle() {
    return handle;
  }

  /** The first number with a code, or the usual one. */
  double number(int code, double usual) {
    int index = codes.indexOf(code);
    return index < 0 ? usual : numbers.get(index);
  }

  int integer(int code, int usual) {
    double number = number(code, usual);
    if (Math.abs(number) > Integer.MAX_VALUE) {
      throw place.error("group %s of %s is %s, expected a whole number", code, type, number);
    }
    return (int) number;
  }

  boolean hasFlag(int bit) {
    return (integer(70, 0) & bit) != 0;
  }

  /** All numbers with a code, in their order. */
  double[] numbers(int code) {
    double[] found = new double[numbers.size()];
    int count = 0;
    for (int i = 0; i < codes.size(); i++) {
      if (codes.get(i) == code) {
        found[count++] = numbers.get(i);
      }
    }
    return Arrays.copyOf(found, count);
  }

  /**
   * Returns points whose x begin with a code: x, y and, if there is one between them and the next
   * point, the value of another code, else 0.
   */
  List<double[]> points(int code, int extra) {
    List<double[]> points = new ArrayList<>();
    for (int i = 0; i < codes.size(); i++) {
      int current = codes.get(i);
      if (current == code) {
        points.add(new double[] {numbers.get(i), 0, 0});
      } else if (!points.isEmpty() && current == code + 10) {
        points.get(points.size() - 1)[1] = numbers.get(i);
      } else if (!points.isEmpty() && current == extra) {
        points.get(points.size() - 1)[2] = numbers.get(i);
      }
    }
    return points;
  }

  /** Whether the entity lies in the plane, seen from above or below. */
  boolean isFlat() {
    return number(210, 0) == 0 && number(220, 0) == 0;
  }

  /** The transform from the coordinates of the entity to those of the drawing. */
  AffineTransform toPlan() {
    return number(230, 1) < 0 ? AffineTransform.getScaleInstance(-1, 1) : new AffineTransform();
  }
}
