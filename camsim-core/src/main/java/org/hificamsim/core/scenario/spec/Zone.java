package org.hificamsim.core.scenario.spec;

import java.awt.geom.Line2D;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.detection.Seen;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Range;
import org.hificamsim.core.scenario.declaration.Type;

/**
 * A part of the field where something is demanded of the cameras.
 *
 * @param points the points, metres: two opposite corners of a rectangle, the corners of a polygon,
 *     or the points along a line; empty for the whole field
 * @param detection the detection that must see there; null for the scenario's
 * @param k the number of cameras that must see there; null for that of the scenario's objective
 * @param weight the worth of seeing the zone; 0 for a zone that demands nothing
 * @param facing the heading of the faces that have to be seen, in degrees; null for any
 * @param facingTolerance the greatest angle from that heading to the camera, in degrees; null for
 *     {@value #USUAL_TOLERANCE}
 * @param maxDepression the steepest angle at which cameras may look down at a face, in degrees;
 *     null for any
 */
public record Zone(
    String name,
    Shape shape,
    List<Point> points,
    String detection,
    Integer k,
    Double weight,
    Double facing,
    Double facingTolerance,
    Double maxDepression) {
  /** The shape of a zone. */
  public enum Shape {
    RECTANGLE(2, 2),
    POLYGON(3, Integer.MAX_VALUE),
    POLYLINE(2, Integer.MAX_VALUE),
    FIELD(0, 0);

    private final int least;
    private final int most;

    Shape(int least, int most) {
      this.least = least;
      this.most = most;
    }
  }

  /**
   * The angle up to which recognition of faces works about as well as from the front, in degrees.
   */
  private static final double USUAL_TOLERANCE = 30;

  /** Half the width of the strip along a polyline, in metres. */
  private static final double HALF_STRIP = 0.5;

  /** The attribute that needs a world with heights. */
  public static final String MAX_DEPRESSION = "max_depression";

  /** The value of {@link #MAX_DEPRESSION} that is expected without heights, for messages. */
  public static final String NO_DEPRESSION =
      "none in a flat world: give cameras a z, or obstacles heights";

  public static final Element<Zone> ELEMENT =
      Element.ofRecord(
          "zone",
          Zone.class,
          """
A part of the field where something is demanded of the cameras (ours): `place` plans for \
it, and the page of `run --heatmap` says how much of it is covered.
name: unique
shape: `rectangle` between two opposite corners, `polygon`, `polyline`: a strip of a metre \
along a line, or the whole `field`
points: m, as in `0,0 4,0 4,3` | none, of the whole field
detection: what has to see there, as `oodpcvs-2025:level=validate` | the scenario's
k: how many cameras have to see it at once | those of the objective `covered:k`, else 1
weight: what seeing a part of it is worth compared with as large a part of others, 0 or more
facing: degrees, as a heading: where faces look that have to be seen; a camera counts only if it \
is on that side | none: cameras on all sides count
facing_tolerance: degrees from `facing` to the camera at most | 30
max_depression: degrees below the horizon at which a camera may look down at the top of a head, \
in a world with heights | any
""");

  static {
    ELEMENT.required("name", Type.text("a name that no other zone has"));
    ELEMENT.attribute("shape", Type.choice(Shape.class), Shape.RECTANGLE);
    ELEMENT.optional("points", Type.PLACES, List.<Point>of());
    ELEMENT.optional("detection", Type.TEXT);
    ELEMENT.optional("k", Type.whole(1, 100));
    ELEMENT.optional("weight", Type.number(Range.NON_NEGATIVE), 1.0);
    ELEMENT.optional("facing", Type.number(Range.TURN));
    ELEMENT.optional("facing_tolerance", Type.number(Range.UP_TO_180));
    ELEMENT.optional(MAX_DEPRESSION, Type.number(Range.UP_TO_90));
  }

  /**
   * Checks the number of points.
   *
   * @throws IllegalArgumentException if the number does not fit the shape
   */
  public Zone {
    points = List.copyOf(points);
    if (points.size() < shape.least || points.size() > shape.most) {
      String number = shape.least == shape.most ? "" + shape.least : shape.least + " or more";
      throw new IllegalArgumentException(
          "has %s points, expected %s of a %s"
              .formatted(points.size(), number, Spelling.of(shape)));
    }
    if (facing == null && facingTolerance != null) {
      throw new IllegalArgumentException("has a facing_tolerance, expected facing, too");
    }
    if (shape == Shape.POLYGON) {
      new Obstacle.Polygon(points, 1); // checks the points
    }
  }

  /** Returns a zone that demands what the scenario does. */
  public static Zone of(String name, Shape shape, List<Point> points) {
    return new Zone(name, shape, points, null, null, 1.0, null, null, null);
  }

  /** The whole field, for scenarios that have no zones. */
  public static Zone ofField() {
    return of("field", Shape.FIELD, List.of());
  }

  /** Returns the zones of a site: the whole field if there are none. */
  public static List<Zone> ofSite(List<Zone> zones) {
    return zones.isEmpty() ? List.of(ofField()) : zones;
  }

  /** Returns the zone under another name. */
  public Zone named(String newName) {
    return new Zone(
        newName, shape, points, detection, k, weight, facing, facingTolerance, maxDepression);
  }

  /** Returns the zone at another place. */
  public Zone withPoints(List<Point> newPoints) {
    return new Zone(
        name, shape, newPoints, detection, k, weight, facing, facingTolerance, maxDepression);
  }

  /** Fills in the detection and the number of cameras that the zone does not give. */
  public Zone withDefaults(String defaultDetection, Objective objective) {
    int cameras = objective instanceof Objective.Covered covered ? covered.k() : 1;
    String requiredDetection = detection == null ? defaultDetection : detection;
    return with(requiredDetection, k == null ? cameras : k);
  }

  /** Returns the zone with another number of cameras that have to see it. */
  public Zone demanding(int cameras) {
    return with(detection, cameras);
  }

  private Zone with(String requiredDetection, int cameras) {
    return new Zone(
        name,
        shape,
        points,
        requiredDetection,
        cameras,
        weight,
        facing,
        facingTolerance,
        maxDepression);
  }

  /** The part of a target that cameras must see; empty if the zone leaves it to others. */
  public Optional<Seen> seen() {
    return asksForFaces() ? Optional.of(Seen.FACE) : Optional.empty();
  }

  /** Whether it matters from where cameras see a target. */
  public boolean asksForFaces() {
    return facing != null || maxDepression != null;
  }

  /**
   * Whether a camera sees a face as the zone asks: from where it looks, and not too steeply from
   * above.
   *
   * @param east metres to the east from the face to the camera
   * @param north metres to the north from the face to the camera
   * @param above metres from the top of the head up to the camera; NaN in a flat world
   */
  public boolean showsFace(double east, double north, double above) {
    return isInFront(east, north)
        && (maxDepression == null
            || !(Math.toDegrees(Math.atan2(above, Math.hypot(east, north))) > maxDepression));
  }

  private boolean isInFront(double east, double north) {
    if (facing == null) {
      return true;
    }
    double heading = Math.toDegrees(Math.atan2(east, north));
    return Math.abs(Math.IEEEremainder(heading - facing, 360)) <= tolerance();
  }

  /**
   * The greatest angle between the heading of a face and the direction to the camera, in degrees.
   */
  public double tolerance() {
    return facingTolerance == null ? USUAL_TOLERANCE : facingTolerance;
  }

  /** Whether a point of the field is in the zone or on its border. */
  public boolean contains(double x, double y) {
    return switch (shape) {
      case FIELD -> true;
      case RECTANGLE ->
          between(x, points.get(0).x(), points.get(1).x())
              && between(y, points.get(0).y(), points.get(1).y());
      case POLYGON -> new Obstacle.Polygon(points, 1).contains(x, y);
      case POLYLINE -> isOnLine(x, y);
    };
  }

  /** The smallest rectangle that contains the part of the zone in the field. */
  public Field bounds(Field field) {
    if (shape == Shape.FIELD) {
      return field;
    }
    double strip = shape == Shape.POLYLINE ? HALF_STRIP : 0;
    DoubleSummaryStatistics xs = points.stream().mapToDouble(Point::x).summaryStatistics();
    DoubleSummaryStatistics ys = points.stream().mapToDouble(Point::y).summaryStatistics();
    double minX = Math.max(field.minX(), xs.getMin() - strip);
    double minY = Math.max(field.minY(), ys.getMin() - strip);
    return new Field(
        minX,
        Math.max(minX, Math.min(field.maxX(), xs.getMax() + strip)),
        minY,
        Math.max(minY, Math.min(field.maxY(), ys.getMax() + strip)));
  }

  private static boolean between(double value, double end, double otherEnd) {
    return value >= Math.min(end, otherEnd) && value <= Math.max(end, otherEnd);
  }

  private boolean isOnLine(double x, double y) {
    for (int i = 1; i < points.size(); i++) {
      Point from = points.get(i - 1);
      Point to = points.get(i);
      if (Line2D.ptSegDist(from.x(), from.y(), to.x(), to.y(), x, y) <= HALF_STRIP) {
        return true;
      }
    }
    return false;
  }
}
