package org.hificamsim.core.scenario.spec;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.hificamsim.core.detection.Seen;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Spec;
import org.hificamsim.core.scenario.declaration.Type;
import org.hificamsim.core.scenario.track.Track;

/** A target as the scenario gives it, and how it moves. */
public final class TargetSpec extends Spec<TargetSpec> {
  /** The largest object of the thesis's lab (Table 4.1). */
  public static final double DEFAULT_SIZE = 0.66;

  /** The movement of a target with a track, which a file gives by {@code tracks}, never by name. */
  public static final String TRACKS = "Tracks";

  private static final String CAMSIM_PACKAGE = "epics.movement.";
  private static final Set<String> ON_PATH = Set.of("Waypoints", "Scripted");
  private static final Type<String> MOVEMENT =
      Type.text(
          "a movement such as Straight, Waypoints, Brownian, DirectedBrownian, or one in a jar");

  /** The elements that bring a target. */
  public enum Origin {
    /** {@code object}. */
    OBJECT,
    /** {@code object_with_waypoints}. */
    OBJECT_WITH_WAYPOINTS,
    /** An event that adds an object. */
    EVENT,
    /** {@code tracks}. */
    TRACK
  }

  public static final Element<TargetSpec> ELEMENT =
      Element.of(
              "object",
              TargetSpec.class,
              TargetSpec::new,
              """
A target that is there from the start.
features: a number that identifies it; unique
move: its movement: `epics.movement.` and `Straight`, `Waypoints`, `Brownian`, \
`DirectedBrownian`; `Scripted` or `RandomWaypoint` (ours), or the name of a \
movement of your own
x, y: start, m; outside the field is a warning
heading: where it goes: see `headings` above
speed: metres a step
size: edge of its bounding box, m, above 0 (ours)
width, height: in place of `size`, both, m, above 0 (ours): its size is the root of \
their product, and its width is what hides others
seen: what of it has to be [seen](world.md#heights): `feet`, `head`, `face`, `whole` (ours) \
| the scenario's
mean, std: mean and standard deviation of a Brownian step, in x and y, m
""")
          .holds("(waypoint, waypoint+)?");

  public static final Property<TargetSpec, Double> FEATURES =
      ELEMENT.required("features", Type.FINITE);

  /** The movement's name as the file gives it; empty if an event gives none. */
  public static final Property<TargetSpec, String> MOVE =
      ELEMENT.attribute("move", MOVEMENT, CAMSIM_PACKAGE + "Straight");

  public static final Property<TargetSpec, Double> X = ELEMENT.required("x", Type.COORDINATE);
  public static final Property<TargetSpec, Double> Y = ELEMENT.required("y", Type.COORDINATE);
  public static final Property<TargetSpec, Double> HEADING =
      ELEMENT.required("heading", Type.FINITE);
  public static final Property<TargetSpec, Double> SPEED = ELEMENT.required("speed", Type.SPEED);
  public static final Property<TargetSpec, Double> SIZE =
      ELEMENT.attribute("size", Type.POSITIVE_LENGTH, DEFAULT_SIZE);
  public static final Property<TargetSpec, Double> WIDTH =
      ELEMENT.optional("width", Type.POSITIVE_LENGTH);
  public static final Property<TargetSpec, Double> HEIGHT =
      ELEMENT.optional("height", Type.POSITIVE_LENGTH);
  public static final Property<TargetSpec, Seen> SEEN =
      ELEMENT.optional("seen", Type.choice(Seen.class));
  public static final Property<TargetSpec, Double> MEAN =
      ELEMENT.attribute("mean", Type.COORDINATE, 0.0);
  public static final Property<TargetSpec, Double> STD = ELEMENT.attribute("std", Type.LENGTH, 1.0);
  public static final Property<TargetSpec, Origin> ORIGIN = ELEMENT.property(Origin.OBJECT);
  public static final Property<TargetSpec, List<Waypoint>> WAYPOINTS = ELEMENT.property(List.of());
  static final Property<TargetSpec, Optional<Track>> TRACK = ELEMENT.property(Optional.empty());

  /** A target on a path. */
  public static final Element<TargetSpec> WITH_WAYPOINTS =
      ELEMENT
          .like(
              "object_with_waypoints",
              "A target on a path, which starts on its first waypoint.",
              List.of(FEATURES, SPEED, SIZE, WIDTH, HEIGHT, SEEN))
          .holds("waypoint, waypoint+");

  /** A target that an event adds. */
  public static final Element<TargetSpec> ADDED =
      ELEMENT
          .like(
              "event",
              "A target comes; with waypoints it starts on the first and walks round them.\n"
                  + "name: its features\nfqName: its movement, as `move` of an object",
              List.of(
                  FEATURES.as("name", null).required(),
                  MOVE.as("fqName", "").omittedAtDefault(),
                  X,
                  Y,
                  HEADING,
                  SPEED,
                  SIZE,
                  WIDTH,
                  HEIGHT,
                  SEEN,
                  MEAN,
                  STD))
          .holds(ELEMENT.content());

  static {
    ADDED.ignored("move", MOVEMENT);
  }

  private TargetSpec(Spec<TargetSpec> spec) {
    super(spec);
  }

  /** Creates a target at a position, in metres, that stands still and looks north. */
  public TargetSpec(double features, double x, double y) {
    super(
        ELEMENT
            .empty()
            .put(FEATURES, features)
            .put(X, x)
            .put(Y, y)
            .put(HEADING, 0.0)
            .put(SPEED, 0.0));
  }

  public double features() {
    return get(FEATURES);
  }

  /** The name in result files: the features value, as CamSim prints it. */
  public String name() {
    return Double.toString(features());
  }

  public Origin origin() {
    return get(ORIGIN);
  }

  /** A coordinate of the start, in metres; may lie outside the field. */
  public double x() {
    return get(X);
  }

  /** A coordinate of the start, in metres; may lie outside the field. */
  public double y() {
    return get(Y);
  }

  public double heading() {
    return get(HEADING);
  }

  /** The speed, metres a step. */
  public double speed() {
    return get(SPEED);
  }

  /** Returns the edge q of the target's bounding box, in metres, above 0. */
  public double size() {
    return find(SIZE).orElseGet(() -> extent().orElseThrow().size());
  }

  /** Returns width and height, which determine the size; empty unless the file gives them. */
  public Optional<Extent> extent() {
    return find(WIDTH).map(width -> new Extent(width, get(HEIGHT)));
  }

  /** The width of the target, seen from above, in metres. */
  public double width() {
    return find(WIDTH).orElseGet(this::size);
  }

  /** The height of the target, in metres. */
  public double height() {
    return find(HEIGHT).orElseGet(this::size);
  }

  /** The part of it that has to be seen, if the file says so for this target. */
  public Optional<Seen> seen() {
    return find(SEEN);
  }

  /** The same target with another size, in metres. */
  public TargetSpec withSize(double size) {
    return without(WIDTH).without(HEIGHT).with(SIZE, size);
  }

  /** The same target with a width and a height. */
  public TargetSpec withExtent(Extent extent) {
    return without(SIZE).with(WIDTH, extent.width()).with(HEIGHT, extent.height());
  }

  /**
   * The short name of its movement; without a name, Waypoints where there are waypoints, else
   * Straight.
   */
  public String movement() {
    String name = get(MOVE);
    if (name.isEmpty()) {
      return waypoints().isEmpty() ? "Straight" : "Waypoints";
    }
    return shortName(name);
  }

  /** A movement's name without CamSim's package. */
  static String shortName(String name) {
    return name.startsWith(CAMSIM_PACKAGE) ? name.substring(CAMSIM_PACKAGE.length()) : name;
  }

  /** The same target under another movement; none but Tracks keeps a track. */
  public TargetSpec withMovement(String name) {
    boolean along = shortName(name).equals(TRACKS);
    return with(MOVE, name).with(TRACK, along ? track() : Optional.empty());
  }

  /** The same target on another track. */
  public TargetSpec along(Track track) {
    return with(X, track.x(0)).with(Y, track.y(0)).with(TRACK, Optional.of(track));
  }

  /** Returns the mean of each coordinate's step, in metres; for Brownian motion only. */
  public double mean() {
    return get(MEAN);
  }

  /**
   * Returns the standard deviation of each coordinate's step, in metres; for Brownian motion only.
   */
  public double std() {
    return get(STD);
  }

  public List<Waypoint> waypoints() {
    return get(WAYPOINTS);
  }

  /** The track that it follows; with the movement Tracks only. */
  public Optional<Track> track() {
    return get(TRACK);
  }

  /** Whether it follows waypoints, and has none. */
  public boolean lacksWaypoints() {
    return waypoints().isEmpty() && ON_PATH.contains(movement());
  }

  /** Whether it follows a track, and has none. */
  public boolean lacksTrack() {
    return track().isEmpty() && movement().equals(TRACKS);
  }
}
