package org.hificamsim.placement.site;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.solver.cover.CoverInstance;

/**
 * The cameras that could be mounted, with the points of the demand that each covers. There is one
 * for every kind at every mount point in every heading and tilt and, by {@code
 * CoverageReading.FIXED}, at every zoom level. Left out are cameras that cover nothing, and those
 * that are superfluous since others on the same mount point cover their points for no higher price.
 *
 * @param list the candidates, in the order of mount points
 * @param covered for each candidate, the points that it covers, rising
 * @param places the number of mount points from which cameras looked
 */
public record Candidates(List<Candidate> list, int[][] covered, int places) {
  /** The angle from one heading to the next, in degrees. */
  static final int HEADING_STEP = 15;

  /** The number of mount points from which cameras look in any case. */
  private static final Pattern SET_ANGLE = Pattern.compile(" at [0-9.]+ degrees$");

  private static final int MIN_PLACES = 8;

  private static final double GOLDEN_RATIO = (Math.sqrt(5) - 1) / 2;

  /** The tilts of cameras on sites with heights, in degrees below the horizon. */
  private static final List<Double> TILTS = List.of(0.0, 15.0, 30.0);

  /** A camera that could be mounted. */
  public record Candidate(CameraKind kind, OpticsSpec optics, Mounting mount) {
    /** Returns the candidate on another mount. */
    Candidate on(Mounting newMount) {
      return new Candidate(kind, optics, newMount);
    }

    /** Returns the camera as an element of a scenario. */
    public CameraSpec camera(String name) {
      Point position = mount.position();
      return new CameraSpec(name, position.x(), position.y(), optics.reach().orElse(0))
          .with(CameraSpec.Z, mount.z())
          .with(CameraSpec.TILT, mount.tilt())
          .with(CameraSpec.HEADING, mount.heading())
          .with(CameraSpec.VIEWING_ANGLE, Collections.max(optics.anglesOfView()))
          .with(CameraSpec.OPTICS, optics);
    }
  }

  /**
   * The cameras that can be mounted, and where.
   *
   * @param points where cameras can be mounted
   * @param kinds the kinds of cameras
   */
  public record Options(List<Point> points, List<CameraKind> kinds) {}

  /**
   * The effort for finding candidates.
   *
   * @param stop whether to leave out the mount points that are not yet reached; a few are reached
   *     in any case
   * @param finished action to run for each mount point whose candidates are known
   */
  public record Work(int threads, BooleanSupplier stop, Runnable finished) {}

  private record CoveringCandidate(Candidate candidate, int[] covered) {}

  /**
   * Returns the candidates of a site. If the work is stopped, the mount points that were reached
   * lie all over the site.
   */
  public static Candidates of(
      Options options, CoverageReading reading, PointSight sight, Work work) {
    int[] needs = sight.demand().needs();
    AtomicInteger places = new AtomicInteger();
    Function<Integer, List<CoveringCandidate>> look =
        number -> {
          if (places.get() >= MIN_PLACES && work.stop.getAsBoolean()) {
            return List.of();
          }
          places.incrementAndGet();
          List<CoveringCandidate> candidates =
              candidatesAt(options.points.get(number), options.kinds, reading, sight);
          work.finished.run();
          return undominated(candidates, needs);
        };
    List<Integer> order = spread(options.points.size());
    List<List<CoveringCandidate>> found = Parallel.map(order, work.threads, look);
    List<CoveringCandidate> candidates =
        IntStream.range(0, order.size())
            .boxed()
            .sorted(Comparator.comparing(order::get))
            .flatMap(i -> found.get(i).stream())
            .toList();
    return new Candidates(
        candidates.stream().map(CoveringCandidate::candidate).toList(),
        candidates.stream().map(CoveringCandidate::covered).toArray(int[][]::new),
        places.get());
  }

  /**
   * Returns the numbers below a count in an order of which any first part is spread over all of
   * them: that of the fractional parts of multiples of the golden ratio.
   */
  private static List<Integer> spread(int count) {
    return IntStream.range(0, count)
        .boxed()
        .sorted(Comparator.comparingDouble(number -> number * GOLDEN_RATIO % 1))
        .toList();
  }

  private static List<CoveringCandidate> undominated(
      List<CoveringCandidate> candidates, int[] needs) {
    CoverInstance instance =
        new CoverInstance(
            new double[needs.length],
            needs,
            candidates.stream().map(CoveringCandidate::covered).toArray(int[][]::new),
            candidates.stream().mapToDouble(covering -> covering.candidate.kind.price()).toArray());
    return Arrays.stream(instance.undominatedCandidates()).mapToObj(candidates::get).toList();
  }

  /** Returns for each candidate its price. */
  public double[] prices() {
    return list.stream().mapToDouble(candidate -> candidate.kind.price()).toArray();
  }

  private static List<CoveringCandidate> candidatesAt(
      Point point, List<CameraKind> kinds, CoverageReading reading, PointSight sight) {
    List<Candidate> scouts = scouts(point, kinds, reading, sight.demand().site());
    int[][][] seen =
        sight.seenByView(
            IntStream.range(0, scouts.size())
                .mapToObj(number -> scouts.get(number).camera("scout " + number))
                .toList());
    return IntStream.range(0, scouts.size())
        .boxed()
        .flatMap(number -> candidates(scouts.get(number), reading, seen[number]))
        .filter(candidate -> candidate.covered.length > 0)
        .toList();
  }

  /**
   * Returns a camera of each kind, at each tilt, that can look in every heading. A single simulated
   * world with these cameras shows what the candidates of all headings see.
   */
  private static List<Candidate> scouts(
      Point point, List<CameraKind> kinds, CoverageReading reading, Scenario site) {
    Optional<Double> z = Mounting.newHeightOn(site);
    List<Candidate> scouts = new ArrayList<>();
    for (CameraKind kind : kinds) {
      OpticsSpec panning = kind.optics().with(OpticsSpec.PANS, angles(kind.optics(), reading));
      boolean fixed = reading == CoverageReading.FIXED;
      OpticsSpec optics = fixed ? panning.with(OpticsSpec.TILTS, List.of(0.0)) : panning;
      for (double tilt : canTilt(site, optics) ? TILTS : List.of(0.0)) {
        scouts.add(new Candidate(kind, optics, new Mounting(point, z, tilt, 0)));
      }
    }
    return scouts;
  }

  /** Whether cameras hang at a height and have lenses with vertical angles. */
  static boolean canTilt(Scenario site, OpticsSpec optics) {
    return site.hasHeights() && optics.law() == OpticsLaw.PINHOLE;
  }

  private static List<Double> headings() {
    return IntStream.range(-180 / HEADING_STEP, 180 / HEADING_STEP)
        .mapToObj(number -> (double) HEADING_STEP * number)
        .toList();
  }

  /** Returns all angles at which a lens can look if it is mounted in any heading, rising. */
  private static List<Double> angles(OpticsSpec optics, CoverageReading reading) {
    return reading == CoverageReading.FIXED
        ? headings()
        : headings().stream()
            .flatMap(heading -> optics.pans().stream().map(pan -> Mounting.sum(heading, pan)))
            .distinct()
            .sorted()
            .toList();
  }

  /**
   * Returns the candidates of a scout's kind, point and tilt.
   *
   * @param seen for each view of the scout, the points that it sees
   */
  private static Stream<CoveringCandidate> candidates(
      Candidate scout, CoverageReading reading, int[][] seen) {
    return reading == CoverageReading.FIXED ? fixed(scout, seen) : turning(scout, seen);
  }

  /**
   * Returns a candidate for each heading and zoom level. The scout's views are numbered as in
   * {@link org.hificamsim.core.policy.NetworkView}: all levels of a heading, then those of the
   * next.
   */
  private static Stream<CoveringCandidate> fixed(Candidate scout, int[][] seen) {
    OpticsSpec optics = scout.kind.optics();
    List<Double> headings = headings();
    int levels = optics.anglesOfView().size();
    return IntStream.range(0, headings.size() * levels)
        .mapToObj(
            view -> {
              Mounting mount = scout.mount.turnedBy(headings.get(view / levels));
              OpticsSpec fixedOptics = atLevel(optics, view % levels);
              return new CoveringCandidate(
                  new Candidate(scout.kind, fixedOptics, mount), seen[view]);
            });
  }

  /**
   * Returns a candidate that can pan and zoom for each heading; a single one if it looks all round.
   */
  private static Stream<CoveringCandidate> turning(Candidate scout, int[][] seen) {
    OpticsSpec optics = scout.kind.optics();
    List<Double> angles = angles(optics, CoverageReading.ANY);
    int viewsPerAngle = optics.anglesOfView().size() * optics.tilts().size();
    TreeMap<Double, int[]> seenByAngle = new TreeMap<>();
    for (int i = 0; i < angles.size(); i++) {
      int first = i * viewsPerAngle;
      Stream<int[]> views = IntStream.range(first, first + viewsPerAngle).mapToObj(v -> seen[v]);
      seenByAngle.put(angles.get(i), PointSight.union(views));
    }
    boolean allRound = angles.size() == optics.pans().size();
    List<Double> headings = allRound ? List.of(0.0) : headings();
    return headings.stream()
        .map(
            heading -> {
              Stream<int[]> inReach =
                  optics.pans().stream().map(pan -> seenByAngle.get(Mounting.sum(heading, pan)));
              return new CoveringCandidate(
                  new Candidate(scout.kind, optics, scout.mount.turnedBy(heading)),
                  PointSight.union(inReach));
            });
  }

  /** The name of the product whose lens {@link #atLevel} has set, or the name of any other lens. */
  static String productOf(OpticsSpec optics) {
    return SET_ANGLE.matcher(optics.name()).replaceFirst("");
  }

  /** Returns a lens that stays at one of its levels. */
  static OpticsSpec atLevel(OpticsSpec optics, int level) {
    List<Double> angles = optics.anglesOfView();
    List<Double> verticalAngles = optics.get(OpticsSpec.VERTICAL_ANGLES);
    boolean hasVertical = level < verticalAngles.size();
    OpticsSpec fixed =
        optics
            .with(OpticsSpec.NAME, "%s at %s degrees".formatted(optics.name(), angles.get(level)))
            .with(OpticsSpec.ANGLES_OF_VIEW, List.of(angles.get(level)))
            .with(
                OpticsSpec.VERTICAL_ANGLES,
                hasVertical ? List.of(verticalAngles.get(level)) : verticalAngles)
            .with(OpticsSpec.PANS, List.of(0.0))
            .with(OpticsSpec.TILTS, List.of(0.0))
            .with(OpticsSpec.ZOOM_TIME, 0)
            .without(OpticsSpec.PAN_SPEED);
    if (optics.reach().isEmpty()) {
      return fixed;
    }
    List<Double> radii = optics.law().radii(angles, optics.reach().getAsDouble());
    return fixed.with(OpticsSpec.REACH, radii.get(level));
  }
}
