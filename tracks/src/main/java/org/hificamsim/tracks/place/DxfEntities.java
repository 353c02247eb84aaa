package org.hificamsim.tracks.place;

import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.hificamsim.tracks.place.DxfEntity.Circle;
import org.hificamsim.tracks.place.DxfEntity.Content;
import org.hificamsim.tracks.place.DxfEntity.Insert;
import org.hificamsim.tracks.place.DxfEntity.Other;
import org.hificamsim.tracks.place.DxfEntity.Outline;
import org.hificamsim.tracks.place.OutlineMaker.Kind;

/** Reads the entities of a DXF (AutoCAD's DXF reference, releases 12 to 2018). */
final class DxfEntities {
  private static final int CLOSED = 1;
  private static final int MESH = 16 | 64;
  private static final int FRAME_OF_SPLINE = 16;

  private static final int MAX_CORNERS = 2_000_000;

  private final DxfTags tags;

  DxfEntities(DxfTags tags) {
    this.tags = tags;
  }

  /** Reads the entity that the current pair begins, with all entities that belong to it. */
  DxfEntity read() {
    DxfFields fields = DxfFields.read(tags);
    Content content = content(fields);
    if (fields.integer(67, 0) == 1) {
      content = new Other("in paper space");
    } else if (fields.integer(60, 0) == 1) {
      content = new Other("hidden");
    }
    return new DxfEntity(
        fields.place(),
        fields.layer(),
        fields.integer(62, DxfEntity.COLOUR_OF_LAYER),
        fields.handle(),
        content);
  }

  private Content content(DxfFields fields) {
    return switch (fields.type()) {
      case "LINE" ->
          new Outline(
              new Line2D.Double(
                  fields.number(10, 0),
                  fields.number(20, 0),
                  fields.number(11, 0),
                  fields.number(21, 0)),
              Kind.LINES);
      case "LWPOLYLINE" ->
          lines(fields, DxfCurves.polyline(fields.points(10, 42), fields.hasFlag(CLOSED)));
      case "POLYLINE" -> polyline(fields);
      case "ARC" -> lines(fields, arc(fields));
      case "CIRCLE" -> circle(fields);
      case "ELLIPSE" -> ellipse(fields);
      case "SPLINE" -> new Outline(spline(fields), Kind.LINES);
      case "SOLID", "TRACE" -> solid(fields);
      case "INSERT" -> insert(fields);
      default -> new Other(fields.type().toLowerCase(Locale.ROOT));
    };
  }

  private static Content lines(DxfFields fields, Shape shape) {
    return flat(fields, new Outline(fields.toPlan().createTransformedShape(shape), Kind.LINES));
  }

  /** Leaves out an entity that does not lie in the plane. */
  private static Content flat(DxfFields fields, Content content) {
    return fields.isFlat()
        ? content
        : new Other("upright " + fields.type().toLowerCase(Locale.ROOT));
  }

  private Content polyline(DxfFields fields) {
    List<double[]> corners = new ArrayList<>();
    boolean ended = false;
    while (!ended) {
      tags.next();
      if (!tags.is(0, "VERTEX") && !tags.is(0, "SEQEND")) {
        tags.hold();
        break;
      }
      DxfFields part = DxfFields.read(tags);
      ended = part.type().equals("SEQEND");
      if (!ended && !part.hasFlag(FRAME_OF_SPLINE)) {
        corners.addAll(part.points(10, 42));
      }
      if (corners.size() > MAX_CORNERS) {
        throw part.place().error("POLYLINE has too many points, expected fewer");
      }
    }
    return fields.hasFlag(MESH)
        ? new Other("mesh")
        : lines(fields, DxfCurves.polyline(corners, fields.hasFlag(CLOSED)));
  }

  private static Shape arc(DxfFields fields) {
    double start = fields.number(50, 0);
    double sweep = (fields.number(51, 360) - start) % 360;
    return DxfCurves.arc(
        fields.number(10, 0),
        fields.number(20, 0),
        Math.abs(fields.number(40, 0)),
        start,
        sweep <= 0 ? sweep + 360 : sweep);
  }

  private static Content circle(DxfFields fields) {
    double radius = Math.abs(fields.number(40, 0));
    double x = fields.number(10, 0);
    double y = fields.number(20, 0);
    Shape circle = new Ellipse2D.Double(x - radius, y - radius, 2 * radius, 2 * radius);
    return flat(fields, new Circle(fields.toPlan().createTransformedShape(circle)));
  }

  private static Content ellipse(DxfFields fields) {
    double start = fields.number(41, 0);
    double end = fields.number(42, 2 * Math.PI);
    boolean isWhole = Math.abs(end - start) >= 2 * Math.PI - 1e-6;
    double ratio = Math.copySign(fields.number(40, 1), fields.number(230, 1));
    Shape shape =
        DxfCurves.ellipse(
            new double[] {fields.number(10, 0), fields.number(20, 0)},
            new double[] {fields.number(11, 1), fields.number(21, 0)},
            ratio,
            start,
            end);
    return flat(fields, new Outline(shape, isWhole ? Kind.SOLID : Kind.LINES));
  }

  private static Shape spline(DxfFields fields) {
    List<double[]> control = fields.points(10, -1);
    double[] weights = fields.numbers(41);
    for (int i = 0; i < control.size(); i++) {
      control.get(i)[2] = i < weights.length ? weights[i] : 1;
    }
    List<double[]> fitted = fields.points(11, -1);
    if (control.isEmpty() && fitted.size() > 1) {
      return DxfCurves.polyline(fitted, false);
    }
    int degree = fields.integer(71, 3);
    if (!DxfCurves.isSpline(degree, control, fields.numbers(40))) {
      throw fields
          .place()
          .error(
              "SPLINE has degree %s, %s points and %s knots, expected rising knots, as many as"
                  + " points and degree and one, and weights above 0",
              degree, control.size(), fields.numbers(40).length);
    }
    return DxfCurves.spline(degree, control, fields.numbers(40));
  }

  private static Content solid(DxfFields fields) {
    List<double[]> corners = new ArrayList<>();
    for (int code : new int[] {10, 11, 13, 12}) { // the last two are crossed
      if (code != 13 || !fields.points(13, -1).isEmpty()) {
        corners.add(new double[] {fields.number(code, 0), fields.number(code + 10, 0), 0});
      }
    }
    Shape shape = DxfCurves.polyline(corners, true);
    return fields.isFlat()
        ? new Outline(fields.toPlan().createTransformedShape(shape), Kind.SOLID)
        : new Other("upright solid");
  }

  private Content insert(DxfFields fields) {
    if (fields.integer(66, 0) == 1) {
      skipAttributes();
    }
    AffineTransform toParent = fields.toPlan();
    toParent.translate(fields.number(10, 0), fields.number(20, 0));
    toParent.rotate(Math.toRadians(fields.number(50, 0)));
    int[] grid = {Math.max(1, fields.integer(70, 1)), Math.max(1, fields.integer(71, 1))};
    double[] spacing = {fields.number(44, 0), fields.number(45, 0)};
    double[] scale = {fields.number(41, 1), fields.number(42, 1)};
    return flat(fields, new Insert(fields.name(), toParent, scale, grid, spacing));
  }

  private void skipAttributes() {
    tags.next();
    while (tags.is(0, "ATTRIB")) {
      DxfFields.read(tags);
      tags.next();
    }
    if (tags.is(0, "SEQEND")) {
      DxfFields.read(tags);
    } else {
      tags.hold();
    }
  }
}
