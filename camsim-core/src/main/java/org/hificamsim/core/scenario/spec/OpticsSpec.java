package org.hificamsim.core.scenario.spec;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Range;
import org.hificamsim.core.scenario.declaration.Spec;
import org.hificamsim.core.scenario.declaration.Type;

/**
 * The optics of a camera: the views that it can choose, and the time that it takes to move between
 * them. Optics with only a name are a lens without angles of view that looks ahead and moves at
 * once.
 */
public final class OpticsSpec extends Spec<OpticsSpec> {
  /** The width over the height of a picture in high definition. */
  private static final double DEFAULT_ASPECT = 16.0 / 9;

  /** The optics that a camera refers to by name; the reader finds them. */
  public static final Type<OpticsSpec> BY_NAME = Type.named("", OpticsSpec::new, OpticsSpec::name);

  public static final Element<OpticsSpec> ELEMENT =
      Element.of(
          "optics",
          OpticsSpec.class,
          OpticsSpec::new,
          """
What a camera can choose from, zoom levels times pan angles, and how fast it moves (ours).
name: unique among optics
law: `pinhole`: a lens, which reaches as far as the detection model does. \
`constant-area`: the sector's area is the same at every level. `round`: the camera's own \
`viewing_angle` and the radii of the zoom list, or its `range`
pixels: width of the picture, 1 to 100,000; density models count by it \
| the model's, 1920
hfov: horizontal angles of view, degrees, one for each zoom level, in any order; with \
`pinhole` below 180, with `constant-area` at most 180 | required, but with `round`
focal_length: in place of `hfov`: focal lengths, in the unit of `sensor_width` (Eq 3.1)
sensor_width: width of the sensor; required with `focal_length`
vfov: vertical angles of view, degrees, below 180, one for each of `hfov`; with `pinhole` alone, \
in a scenario with [heights](world.md#heights) | from `aspect`
aspect: width of the picture over its height, above 0; in place of `vfov` | 16/9
reach: m; with `constant-area` (required) of the narrowest level, with `pinhole` of all \
levels | `pinhole`: no end
pan: angles off the camera's heading, degrees, clockwise
tilt: angles off the camera's `tilt`, degrees, downwards; with `pinhole` alone
pan_speed: degrees a second, also of `tilt` | it turns at once
zoom_time: seconds from the first level to the last, spread evenly over the levels between
moving: what is seen on the way: `blind` nothing, `sees` the nearest of its views
""");

  public static final Property<OpticsSpec, String> NAME =
      ELEMENT.required("name", Type.text("a name that no other optics have"));
  public static final Property<OpticsSpec, OpticsLaw> LAW =
      ELEMENT.attribute("law", Type.choice(OpticsLaw.class), OpticsLaw.PINHOLE);
  public static final Property<OpticsSpec, Integer> PIXELS =
      ELEMENT.optional("pixels", Type.whole(1, 100_000));
  public static final Property<OpticsSpec, List<Double>> ANGLES_OF_VIEW =
      ELEMENT.optional("hfov", Type.numbers(Range.UP_TO_180), List.<Double>of());
  public static final Property<OpticsSpec, List<Double>> FOCAL_LENGTHS =
      ELEMENT.optional("focal_length", Type.numbers(Range.POSITIVE));
  public static final Property<OpticsSpec, Double> SENSOR_WIDTH =
      ELEMENT.optional("sensor_width", Type.POSITIVE);
  public static final Property<OpticsSpec, Double> REACH =
      ELEMENT.optional("reach", Type.POSITIVE_LENGTH);
  public static final Property<OpticsSpec, List<Double>> PANS =
      ELEMENT.attribute("pan", Type.numbers(Range.TURN), List.of(0.0));
  public static final Property<OpticsSpec, List<Double>> TILTS =
      ELEMENT.optional("tilt", Type.numbers(Range.TURN), List.of(0.0));
  public static final Property<OpticsSpec, List<Double>> VERTICAL_ANGLES =
      ELEMENT.optional("vfov", Type.numbers(Range.BELOW_180), List.<Double>of());
  public static final Property<OpticsSpec, Double> ASPECT =
      ELEMENT.optional("aspect", Type.POSITIVE);
  public static final Property<OpticsSpec, Double> PAN_SPEED =
      ELEMENT.optional("pan_speed", Type.POSITIVE);
  public static final Property<OpticsSpec, Double> ZOOM_TIME =
      ELEMENT.attribute("zoom_time", Type.number(Range.TIME), 0.0);
  public static final Property<OpticsSpec, Moving> MOVING =
      ELEMENT.attribute("moving", Type.choice(Moving.class), Moving.BLIND);

  private OpticsSpec(Spec<OpticsSpec> given) {
    super(given);
  }

  /** Creates optics with a name only. */
  public OpticsSpec(String name) {
    super(ELEMENT.empty().put(NAME, name));
  }

  public String name() {
    return get(NAME);
  }

  public OpticsLaw law() {
    return get(LAW);
  }

  /** Returns the width of the picture in pixels, 1 or more; empty if the model decides. */
  public Optional<Integer> pixels() {
    return find(PIXELS);
  }

  public List<Double> anglesOfView() {
    return get(ANGLES_OF_VIEW);
  }

  public OptionalDouble reach() {
    return number(REACH);
  }

  public List<Double> pans() {
    return get(PANS);
  }

  /** Returns the angles off the camera's own tilt, in degrees downwards. */
  public List<Double> tilts() {
    return get(TILTS);
  }

  /** Returns the vertical angles of view, in degrees, one for each of {@link #anglesOfView}. */
  public List<Double> verticalAngles() {
    List<Double> given = get(VERTICAL_ANGLES);
    double aspect = find(ASPECT).orElse(DEFAULT_ASPECT);
    return given.isEmpty()
        ? anglesOfView().stream().map(angle -> angleOver(angle, aspect)).toList()
        : given;
  }

  /**
   * Returns the angle of view in degrees of a focal length on a sensor of this width, both above 0
   * and in the same unit (Eq 3.1).
   */
  public static double angleOfView(double sensorWidth, double focalLength) {
    return 2 * Math.toDegrees(StrictMath.atan(sensorWidth / (2 * focalLength)));
  }

  /**
   * Returns the angle of view, in degrees, of a picture that is smaller by a factor than the
   * picture of another angle.
   */
  private static double angleOver(double angle, double factor) {
    return 2 * Math.toDegrees(StrictMath.atan(StrictMath.tan(Math.toRadians(angle) / 2) / factor));
  }

  /** The same optics without heights. */
  public OpticsSpec flat() {
    return with(VERTICAL_ANGLES, List.<Double>of()).without(ASPECT).with(TILTS, List.of(0.0));
  }

  /** Whether the optics have tilts or vertical angles of view. */
  public boolean hasHeights() {
    return !get(VERTICAL_ANGLES).isEmpty()
        || find(ASPECT).isPresent()
        || !tilts().equals(List.of(0.0));
  }

  /** The speed of turning, degrees a second, above 0; empty if the camera turns at once. */
  public OptionalDouble panSpeed() {
    return number(PAN_SPEED);
  }

  /** The time from the first zoom level to the last, in seconds, 0 or more. */
  public double zoomTime() {
    return get(ZOOM_TIME);
  }

  public Moving moving() {
    return get(MOVING);
  }

  /** Whether the camera needs time for a move. */
  public boolean takesTime() {
    return panSpeed().isPresent() || zoomTime() > 0;
  }
}
