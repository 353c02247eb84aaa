package org.hificamsim.core.scenario.spec;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Range;
import org.hificamsim.core.scenario.declaration.Spec;
import org.hificamsim.core.scenario.declaration.Type;

/** A camera as the scenario describes it. */
public final class CameraSpec extends Spec<CameraSpec> {
  public static final Element<CameraSpec> ELEMENT =
      Element.of(
          "camera",
          CameraSpec.class,
          CameraSpec::new,
          """
A camera that is there from the start.
name: unique
x, y: place, m, inside the field
heading: where it looks, degrees
viewing_angle: full opening angle, degrees, above 0, at most 360; of no effect on a lens \
| required; of a camera with a lens, its widest angle
range: reach, m, 0 or more; of no effect where there is a zoom list or a lens \
| required; of a camera with a lens, its reach
optics: the name of its [optics](#optics) (ours) | none
z: [height](world.md#heights) of the lens above the ground, m (ours) \
| the scenario's `mount_height`, else 0
tilt: how far a lens looks down, degrees, -90 to 90 (ours)
duty: [when it is awake](energy.md#duty-cycles): `2/6@4`, 2 of every 6 steps, first from step 4 \
on (ours) | always
price: what it costs, in any currency, 0 or more; `place` sums it up (ours)
ai_algorithm: class name of an auction schedule of CamSim's network
comm: communication policy in the network: 0 Broadcast, 1 Smooth, 2 Step, 3 Fix, \
4 the class of `customcom`
customcom: class name of a communication policy in the network
limit: the most targets that it may own in the network; 0 for no limit
bandit: class name of a bandit in the network
min_zoom, max_zoom, zoom_steps: in files of the coverage study; of no effect
""");

  public static final Property<CameraSpec, String> NAME =
      ELEMENT.required("name", Type.text("a name that no other camera has"));
  public static final Property<CameraSpec, Double> X = ELEMENT.required("x", Type.COORDINATE);
  public static final Property<CameraSpec, Double> Y = ELEMENT.required("y", Type.COORDINATE);
  public static final Property<CameraSpec, Double> HEADING =
      ELEMENT.required("heading", Type.FINITE);
  public static final Property<CameraSpec, Double> VIEWING_ANGLE =
      ELEMENT.optional("viewing_angle", Type.OPENING);
  public static final Property<CameraSpec, Double> RANGE = ELEMENT.optional("range", Type.LENGTH);
  public static final Property<CameraSpec, OpticsSpec> OPTICS =
      ELEMENT.optional("optics", OpticsSpec.BY_NAME);
  public static final Property<CameraSpec, Double> Z = ELEMENT.optional("z", Type.LENGTH);
  public static final Property<CameraSpec, Double> TILT =
      ELEMENT.optional("tilt", Type.number(Range.TILT), 0.0);
  public static final Property<CameraSpec, DutyCycle> DUTY =
      ELEMENT.optional("duty", Type.named(DutyCycle.EXPECTED, DutyCycle::parse, DutyCycle::text));
  public static final Property<CameraSpec, Double> PRICE =
      ELEMENT.optional("price", Type.number(Range.NON_NEGATIVE), 0.0);
  public static final Property<CameraSpec, String> ALGORITHM =
      ELEMENT.optional("ai_algorithm", Type.TEXT);
  public static final Property<CameraSpec, Integer> COMM =
      ELEMENT.optional("comm", Type.whole(0, 4));
  public static final Property<CameraSpec, String> CUSTOM_COMM =
      ELEMENT.optional("customcom", Type.TEXT);
  public static final Property<CameraSpec, Integer> LIMIT =
      ELEMENT.optional("limit", Type.whole(0), 0);
  public static final Property<CameraSpec, String> BANDIT =
      ELEMENT.optional(
          "bandit", Type.named("", text -> text.isEmpty() ? null : text, text -> text));

  /** The attributes that only CamSim's network reads. */
  public static final List<Property<CameraSpec, ?>> OF_NETWORK =
      List.of(ALGORITHM, COMM, CUSTOM_COMM, LIMIT, BANDIT);

  static {
    ELEMENT.ignored("min_zoom", Type.POSITIVE);
    ELEMENT.ignored("max_zoom", Type.POSITIVE);
    ELEMENT.ignored("zoom_steps", Type.whole(0));
  }

  /** The event that adds a camera, with the attributes that are declared above. */
  public static final Element<CameraSpec> ADDED =
      ELEMENT.like("event", "A camera comes.", ELEMENT.attributes());

  private CameraSpec(Spec<CameraSpec> spec) {
    super(spec);
  }

  /** Creates a camera that sees in all directions; metres. */
  public CameraSpec(String name, double x, double y, double range) {
    super(
        ELEMENT
            .empty()
            .put(NAME, name)
            .put(X, x)
            .put(Y, y)
            .put(HEADING, 0.0)
            .put(VIEWING_ANGLE, 360.0)
            .put(RANGE, range));
  }

  public String name() {
    return get(NAME);
  }

  /** The x coordinate, in metres. */
  public double x() {
    return get(X);
  }

  /** The y coordinate, in metres. */
  public double y() {
    return get(Y);
  }

  /** The heading, in degrees: 0 is +y and 90 is +x. */
  public double heading() {
    return get(HEADING);
  }

  /** Returns the full opening angle, in degrees, (0, 360]. */
  public double viewingAngle() {
    return get(VIEWING_ANGLE);
  }

  /** Returns the radius of the field of view, in metres, 0 or more. */
  public double range() {
    return get(RANGE);
  }

  public Optional<OpticsSpec> optics() {
    return find(OPTICS);
  }

  /**
   * Returns the height above the ground, in metres; empty if the scenario's mount height applies.
   */
  public OptionalDouble z() {
    return number(Z);
  }

  /** The tilt of the camera, degrees below the horizon, [-90, 90]. */
  public double tilt() {
    return get(TILT);
  }

  /** The price in the currency of the plan, 0 or more; 0 if it is not known. */
  public double price() {
    return get(PRICE);
  }

  /** The same camera without heights. */
  public CameraSpec flat() {
    return without(Z).with(TILT, 0).with(OPTICS, optics().map(OpticsSpec::flat));
  }

  /** Whether the camera has a height, a tilt or vertical angles. */
  public boolean hasHeights() {
    return z().isPresent() || tilt() != 0 || optics().filter(OpticsSpec::hasHeights).isPresent();
  }
}
