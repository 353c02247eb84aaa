package org.hificamsim.placement.site;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.core.scenario.spec.OpticsSpec;

/**
 * Cameras that could be mounted, with the samples that each covers: every kind at every place in
 * every heading and, where the fixed view counts, at every zoom level. Those that cover nothing are
 * left out.
 *
 * @param all in the order of places
 * @param columns by candidate: the samples that it covers, rising
 */
public record Candidates(List<Candidate> all, int[][] columns) {
  /** Degrees from one heading to the next. */
  static final int TURN = 15;

  /** Degrees below the horizon, where the site has heights. */
  private static final List<Double> TILTS = List.of(0.0, 15.0, 30.0);

  /** How high new cameras hang where a site with heights does not say, metres. */
  private static final double HIGH = 3;

  /**
   * A camera that could be mounted.
   *
   * @param z metres; empty in a flat world, and where it is the site's own
   * @param tilt degrees
   * @param heading degrees, from -180
   */
  public record Candidate(
      CameraKind kind,
      OpticsSpec optics,
      Point at,
      Optional<Double> z,
      double tilt,
      double heading) {
    /** The same through a lens, elsewhere, at a tilt, turned. */
    Candidate moved(OpticsSpec through, Point to, double downwards, double turn) {
      return new Candidate(kind, through, to, z, downwards, angle(heading, turn));
    }

    /** The camera as a scenario has it. */
    public CameraSpec camera(String name) {
      return new CameraSpec(name, at.x(), at.y(), optics.reach().orElse(0))
          .with(CameraSpec.Z, z)
          .with(CameraSpec.TILT, tilt)
          .with(CameraSpec.HEADING, heading)
          .with(CameraSpec.VIEWING_ANGLE, Collections.max(optics.anglesOfView()))
          .with(CameraSpec.OPTICS, optics);
    }
  }

  private record Found(Candidate candidate, int[] covered) {}

  /** All candidates of a site. */
  public static Candidates of(
      List<Point> places,
      List<CameraKind> kinds,
      CoverageReading reading,
      SampleSight sight,
      int threads) {
    List<Found> found =
        Parallel.map(places, threads, at -> at(at, kinds, reading, sight)).stream()
            .flatMap(List::stream)
            .toList();
    return new Candidates(
        found.stream().map(Found::candidate).toList(),
        found.stream().map(Found::covered).toArray(int[][]::new));
  }

  /** By candidate: what it costs. */
  public double[] prices() {
    return all.stream().mapToDouble(one -> one.kind.price()).toArray();
  }

  private static List<Found> at(
      Point at, List<CameraKind> kinds, CoverageReading reading, SampleSight sight) {
    Scenario site = sight.site();
    Optional<Double> z =
        site.hasHeights() && site.mountHeight().isEmpty() ? Optional.of(HIGH) : Optional.empty();
    List<Candidate> scouts = new ArrayList<>(); // of each kind, at each tilt, all round
    for (CameraKind kind : kinds) {
      OpticsSpec turned = kind.optics().with(OpticsSpec.PANS, angles(kind.optics(), reading));
      boolean still = reading == CoverageReading.FIXED;
      OpticsSpec round = still ? turned.with(OpticsSpec.TILTS, List.of(0.0)) : turned;
      boolean tilts = site.hasHeights() && round.law() == OpticsLaw.PINHOLE;
      for (double tilt : tilts ? TILTS : List.of(0.0)) {
        scouts.add(new Candidate(kind, round, at, z, tilt, 0));
      }
    }
    int[][][] seen =
        sight.seen(
            IntStream.range(0, scouts.size())
                .mapToObj(i -> scouts.get(i).camera("scout " + i))
                .toList());
    return IntStream.range(0, scouts.size())
        .boxed()
        .flatMap(i -> ofScout(scouts.get(i), reading, seen[i]))
        .filter(one -> one.covered.length > 0)
        .toList();
  }

  private static List<Double> headings() {
    return IntStream.range(-180 / TURN, 180 / TURN).mapToObj(i -> (double) TURN * i).toList();
  }

  /** The pan angle of a camera's view in a heading. */
  private static double angle(double heading, double pan) {
    double angle = (heading + pan + 540) % 360 - 180;
    return Math.rint(angle * 1e6) / 1e6;
  }

  /** All angles at which a kind looks in some heading, rising. */
  private static List<Double> angles(OpticsSpec optics, CoverageReading reading) {
    return reading == CoverageReading.FIXED
        ? headings()
        : headings().stream()
            .flatMap(heading -> optics.pans().stream().map(pan -> angle(heading, pan)))
            .distinct()
            .sorted()
            .toList();
  }

  private static Stream<Found> ofScout(Candidate scout, CoverageReading reading, int[][] seen) {
    OpticsSpec optics = scout.kind.optics();
    int levels = optics.anglesOfView().size();
    if (reading == CoverageReading.FIXED) {
      return headings().stream()
          .flatMap(
              heading ->
                  IntStream.range(0, levels)
                      .mapToObj(
                          level ->
                              new Found(
                                  scout.moved(fixed(optics, level), scout.at, scout.tilt, heading),
                                  seen[headings().indexOf(heading) * levels + level])));
    }
    TreeMap<Double, int[]> byAngle = new TreeMap<>();
    List<Double> angles = angles(optics, reading);
    int each = levels * optics.tilts().size();
    for (int i = 0; i < angles.size(); i++) {
      int first = i * each;
      byAngle.put(
          angles.get(i),
          SampleSight.union(IntStream.range(first, first + each).mapToObj(v -> seen[v])));
    }
    boolean round = angles(optics, CoverageReading.ANY).size() == optics.pans().size();
    return (round ? List.of(0.0) : headings())
        .stream()
            .map(
                heading ->
                    new Found(
                        scout.moved(optics, scout.at, scout.tilt, heading),
                        SampleSight.union(
                            optics.pans().stream().map(p -> byAngle.get(angle(heading, p))))));
  }

  /** The same lens at one of its levels. */
  private static OpticsSpec fixed(OpticsSpec optics, int level) {
    List<Double> angles = optics.anglesOfView();
    List<Double> vertical = optics.get(OpticsSpec.VERTICAL_ANGLES);
    OpticsSpec still =
        optics
            .with(OpticsSpec.NAME, "%s at %s degrees".formatted(optics.name(), angles.get(level)))
            .with(OpticsSpec.ANGLES_OF_VIEW, List.of(angles.get(level)))
            .with(
                OpticsSpec.VERTICAL_ANGLES,
                level < vertical.size() ? List.of(vertical.get(level)) : vertical)
            .with(OpticsSpec.PANS, List.of(0.0))
            .with(OpticsSpec.TILTS, List.of(0.0))
            .with(OpticsSpec.ZOOM_TIME, 0)
            .without(OpticsSpec.PAN_SPEED);
    return optics.reach().isPresent()
        ? still.with(
            OpticsSpec.REACH, optics.law().radii(angles, optics.reach().getAsDouble()).get(level))
        : still;
  }
}
