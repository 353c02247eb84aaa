package org.hificamsim.cli;

import static org.hificamsim.cli.Numbers.plain;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.visibility.Body;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.hificamsim.hifi.FittedOn;
import org.hificamsim.hifi.FittedOn.Span;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.OpticalDetection;
import org.hificamsim.hifi.optics.Optics;
import org.hificamsim.runs.Reach;

/** What a detection model makes of a scenario's cameras, in words. */
final class DetectionHints {
  private static final int MAX_LEVELS = 10;
  private static final double FEW = 0.1;
  private static final List<String> OTHERS =
      List.of("hifi:orb-lin", "hifi:orb-pinhole", "oodpcvs-2025:level=overview", "geometric");
  private static final double TOLERANCE = 1.1;
  private static final double NO_LENS = 1e-6;
  private static final int STEPS = 100; // that are looked at

  /** Distances that are computed at most, so that a large scenario takes a moment too. */
  private static final int ENOUGH = 1_000_000;

  private DetectionHints() {}

  /** All warnings about a scenario as one detection sees it. */
  static Stream<String> all(Scenario scenario, Detection used, Catalogue catalogue) {
    return Stream.of(
            smallReach(scenario, used, catalogue),
            lens(scenario, used),
            extrapolation(scenario, used),
            overridden(scenario, used),
            flatRule(scenario, used),
            emptyFootprints(scenario, used, catalogue))
        .flatMap(Optional::stream);
  }

  private static Optional<String> flatRule(Scenario scenario, Detection used) {
    String warning =
        "'%s' is a rule of CamSim, whose world is flat: it gets distances over the"
            + " ground, not those from where cameras hang";
    return Optional.of(warning.formatted(used.name()))
        .filter(any -> scenario.hasHeights() && used.model().flat());
  }

  /** A warning of views of cameras with heights that see no place at all. */
  private static Optional<String> emptyFootprints(
      Scenario scenario, Detection used, Catalogue catalogue) {
    if (!scenario.hasHeights()) {
      return Optional.empty();
    }
    World world = new World(scenario, catalogue.movements(), 0);
    world.sightLines().require(used.model().seen());
    Visibility visibility = Visibility.of(used);
    List<Body> bodies =
        IntStream.range(0, world.targets().count())
            .mapToObj(world.targets()::body)
            .distinct()
            .toList();
    Cameras cameras = world.cameras();
    List<String> blind = new ArrayList<>();
    for (int camera = 0; camera < cameras.count(); camera++) {
      int its = camera;
      List<String> levels =
          IntStream.range(0, cameras.views(camera))
              .mapToObj(view -> cameras.zoom(its, view))
              .distinct()
              .filter(
                  level -> bodies.stream().allMatch(body -> visibility.at(level, body).isBlind()))
              .map(level -> angles(level.viewingAngle(), level.vertical().tilt()))
              .toList();
      if (!levels.isEmpty()) {
        blind.add("'%s' at %s".formatted(cameras.name(camera), first(levels)));
      }
    }
    String warning =
        "no target can be seen anywhere by camera %s: expected another tilt or height,"
            + " or less of a target that has to be seen";
    return Optional.of(warning.formatted(String.join("; ", blind))).filter(any -> !blind.isEmpty());
  }

  private static String angles(double hfov, double tilt) {
    return "hfov " + plain(Math.toDegrees(hfov)) + " tilt " + plain(Math.toDegrees(tilt));
  }

  private static String first(List<String> texts) {
    boolean all = texts.size() <= MAX_LEVELS;
    return String.join(", ", all ? texts : texts.subList(0, MAX_LEVELS)) + (all ? "" : ", ...");
  }

  /** How far a target is detected at each zoom level; by chance, half of the time. */
  static String reach(Scenario scenario, Detection detection) {
    List<String> levels =
        Reach.of(scenario, detection).stream()
            .map(one -> plain(one.detected()) + " of " + plain(one.radius()))
            .toList();
    return first(levels) + " m (a target of " + plain(Reach.largestTarget(scenario)) + " m)";
  }

  /**
   * A warning where hardly any target comes near enough to a camera to be detected, and what would
   * fit.
   */
  private static Optional<String> smallReach(
      Scenario scenario, Detection detection, Catalogue catalogue) {
    double reach = Reach.farthest(scenario, detection);
    World world = new World(scenario, catalogue.movements(), 0);
    int cameras = Math.max(1, world.cameras().count());
    int targets = Math.min(world.targets().count(), Math.max(1, ENOUGH / cameras));
    int steps = Math.max(1, Math.min(STEPS, ENOUGH / Math.max(1, cameras * targets)));
    double[] nearest = nearest(world, targets, steps);
    double median = nearest.length == 0 ? Double.NaN : nearest[nearest.length / 2];
    double within = DoubleStream.of(nearest).filter(one -> one <= reach).count();
    return nearest.length == 0 || within / nearest.length >= FEW
        ? Optional.empty()
        : Optional.of(
            Texts.format(
                "'%s' detects%s up to %s, and %s of the targets come so near to a camera in %s"
                    + " steps (half of them no nearer than %s m): hardly anything is covered;"
                    + " expected %s",
                detection.name(),
                detection.certain() ? "" : " half of the time",
                reach(scenario, detection),
                within == 0 ? "none" : "under " + plain(100 * FEW) + " %",
                steps,
                plain(median),
                fitting(scenario, median, catalogue)));
  }

  /** How far targets are from the camera nearest to them, in metres, the least first. */
  private static double[] nearest(World world, int targets, int steps) {
    DoubleStream.Builder all = DoubleStream.builder();
    for (int step = 0; step < steps; step++) {
      world.fireEvents(step);
      for (int target = 0; target < targets; target++) {
        all.add(world.targets().present(target) ? nearest(world, target) : Double.NaN);
      }
      world.moveTargets();
    }
    return all.build().filter(Double::isFinite).sorted().toArray();
  }

  private static double nearest(World world, int target) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      double dx = world.targets().x(target) - world.cameras().x(camera);
      double dy = world.targets().y(target) - world.cameras().y(camera);
      nearest = world.cameras().online(camera) ? Math.min(nearest, dx * dx + dy * dy) : nearest;
    }
    return Math.sqrt(nearest);
  }

  /** The first of some models that reaches half of the targets. */
  private static String fitting(Scenario scenario, double distance, Catalogue catalogue) {
    return OTHERS.stream()
        .map(name -> Detection.of(catalogue.detection(name)))
        .filter(one -> Reach.farthest(scenario, one) >= distance)
        .findFirst()
        .map(
            one ->
                "another model, such as %s, which reaches %s m"
                    .formatted(one.name(), plain(Reach.farthest(scenario, one))))
        .orElse("longer focal lengths, larger radii or more cameras");
  }

  /**
   * A warning where the scenario's threshold takes the place of that of a model that was asked for.
   */
  private static Optional<String> overridden(Scenario scenario, Detection used) {
    double own = used.model().defaultThreshold();
    return !used.certain()
            || !used.name().equals(used.model().name())
            || scenario.find(Scenario.DETECTION).isPresent()
            || scenario.threshold().orElse(own) != used.threshold()
            || own == used.threshold()
        ? Optional.empty()
        : Optional.of(
            Texts.format(
                "its threshold %s is used for '%s', whose own is %s; expected --detection"
                    + " %s@%s where that one is meant",
                used.threshold(), used.model().name(), own, used.model().name(), own));
  }

  /** A warning where cameras cannot have both their viewing angle and their focal lengths. */
  private static Optional<String> lens(Scenario scenario, Detection detection) {
    return detection.model() instanceof OpticalDetection model
        ? contradiction(scenario, model.optics())
        : Optional.empty();
  }

  private static Optional<String> contradiction(Scenario scenario, Optics optics) {
    List<CameraSpec> wrong =
        scenario.cameras().stream()
            .filter(camera -> contradicts(camera, scenario, optics))
            .toList();
    return wrong.stream()
        .findFirst()
        .map(
            camera ->
                "camera '%s'%s sees %s degrees (viewing_angle), but its focal length gives %s (Eq 3.1); expected a mount_height that makes them agree%s, or viewing_angle 360"
                    .formatted(
                        camera.name(),
                        wrong.size() == 1 ? "" : " (one of " + wrong.size() + ")",
                        plain(camera.viewingAngle()),
                        angles(World.zoomLevels(scenario, camera), optics),
                        agreeing(camera, scenario)));
  }

  private static boolean contradicts(CameraSpec camera, Scenario scenario, Optics optics) {
    List<ZoomLevel> levels = World.zoomLevels(scenario, camera);
    double narrowest = degrees(optics, levels.get(0));
    double widest = degrees(optics, levels.get(levels.size() - 1));
    double angle = camera.viewingAngle();
    return angle < 360 && (angle < narrowest / TOLERANCE || angle > widest * TOLERANCE);
  }

  private static String angles(List<ZoomLevel> levels, Optics optics) {
    String narrowest = plain(degrees(optics, levels.get(0)));
    String widest = plain(degrees(optics, levels.get(levels.size() - 1)));
    return narrowest.equals(widest) ? narrowest : narrowest + " to " + widest;
  }

  /** The angle of view that the focal length gives at a zoom level (Eq 3.1). */
  private static double degrees(Optics optics, ZoomLevel level) {
    return Math.toDegrees(optics.angleOfView(optics.focalLength(level)));
  }

  /** The height at which the widest radius has the viewing angle (Eq 3.2). */
  private static String agreeing(CameraSpec camera, Scenario scenario) {
    List<ZoomLevel> levels = World.zoomLevels(scenario, camera);
    double radius = levels.get(levels.size() - 1).radius();
    double height = radius / Math.tan(Math.toRadians(camera.viewingAngle()) / 2);
    boolean known = camera.viewingAngle() < 180 && radius > 0 && Double.isFinite(height);
    return known ? ", such as " + plain(height) : "";
  }

  /**
   * A warning where sizes of targets, focal lengths or radii of fields of view lie outside what the
   * model was fitted on; none where that is not known.
   */
  private static Optional<String> extrapolation(Scenario scenario, Detection detection) {
    return detection.model() instanceof HiFiDetection model
        ? model.fitted().flatMap(on -> extrapolation(scenario, detection.name(), model, on))
        : Optional.empty();
  }

  private static Optional<String> extrapolation(
      Scenario scenario, String name, HiFiDetection model, FittedOn on) {
    List<ZoomLevel> zooms = World.zoomLevels(scenario);
    List<String> outside = new ArrayList<>();
    add(outside, "sizes", on.size(), scenario.everyTarget().mapToDouble(TargetSpec::size));
    add(
        outside,
        "focal lengths",
        on.focalLength(),
        zooms.stream().mapToDouble(model.optics()::focalLength).filter(z -> z > NO_LENS));
    add(outside, "distances", upTo(on.distance()), zooms.stream().mapToDouble(ZoomLevel::radius));
    String warning =
        "'%s' was not fitted on what is asked of it: %s; expected photos of these, or"
            + " a model whose f is the pinhole camera's";
    return Optional.of(warning.formatted(name, String.join(", ", outside)))
        .filter(any -> !outside.isEmpty());
  }

  /** What is nearer than any photo fills the image, and is detected. */
  private static Span upTo(Span distances) {
    return new Span(0, distances.most());
  }

  private static void add(List<String> outside, String what, Span fitted, DoubleStream asked) {
    double[] values = asked.filter(Double::isFinite).toArray();
    if (values.length > 0) {
      Span span = Span.of(values);
      if (!fitted.contains(span.least()) || !fitted.contains(span.most())) {
        outside.add(what + " " + shown(span) + " m (fitted on " + shown(fitted) + ")");
      }
    }
  }

  private static String shown(Span span) {
    return plain(span.least()) + (span.least() == span.most() ? "" : " to " + plain(span.most()));
  }
}
