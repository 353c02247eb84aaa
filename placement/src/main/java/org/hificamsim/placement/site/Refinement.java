package org.hificamsim.placement.site;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.placement.site.Candidates.Candidate;

/**
 * Improves a plan by moving its cameras to headings, tilts and points between those of the
 * candidates. It moves them in ever smaller steps (pattern search), as long as more of the demand
 * is met. Lenses, heights and prices stay.
 *
 * @param pointsByStep for each step, the points where cameras can be mounted, which are closer
 *     together than those of the step before
 * @param stop ends the refinement early
 */
public record Refinement(List<List<Point>> pointsByStep, int threads, BooleanSupplier stop) {
  /** The number of points to which a camera may move: the nearest ones, on both sides of a wall. */
  private static final int NEAREST_POINTS = 6;

  /** The least gain of a move, as a share of the whole demand. */
  private static final double MIN_GAIN = 1e-9;

  private record CoveringCamera(Candidate candidate, int[] covered) {}

  /** Returns the chosen cameras at the mountings to which they are moved. */
  List<Candidate> refine(PlacementProblem problem, List<Candidate> chosen) {
    int[] counts = problem.keptCounts().clone();
    List<CoveringCamera> cameras = withCoverage(problem, chosen);
    cameras.forEach(camera -> change(counts, camera, 1));
    for (int step = 0; step < pointsByStep.size(); step++) {
      double turn = Candidates.HEADING_STEP / Math.pow(2, step + 1);
      List<Point> points = pointsByStep.get(step);
      Map<Candidate, List<CoveringCamera>> knownMoves = new ConcurrentHashMap<>();
      Function<Candidate, List<CoveringCamera>> computeMoves =
          candidate -> withCoverage(problem, moves(problem, candidate, turn, points));
      Function<CoveringCamera, List<CoveringCamera>> moves =
          camera ->
              stop.getAsBoolean()
                  ? List.of()
                  : knownMoves.computeIfAbsent(camera.candidate, computeMoves);
      boolean moved = true;
      while (moved && !stop.getAsBoolean()) {
        moved = moveAll(problem, counts, cameras, Parallel.map(cameras, threads, moves));
      }
    }
    return cameras.stream().map(CoveringCamera::candidate).toList();
  }

  /**
   * Makes the best move of one camera after another, given the moves before; returns whether any
   * camera moved.
   */
  private static boolean moveAll(
      PlacementProblem problem,
      int[] counts,
      List<CoveringCamera> cameras,
      List<List<CoveringCamera>> moves) {
    double minGain = MIN_GAIN * problem.instance().totalWorth();
    boolean moved = false;
    for (int i = 0; i < cameras.size(); i++) {
      change(counts, cameras.get(i), -1);
      for (CoveringCamera move : moves.get(i)) {
        double gain = problem.instance().gain(counts, move.covered);
        if (gain > problem.instance().gain(counts, cameras.get(i).covered) + minGain) {
          cameras.set(i, move);
          moved = true;
        }
      }
      change(counts, cameras.get(i), 1);
    }
    return moved;
  }

  private static List<CoveringCamera> withCoverage(
      PlacementProblem problem, List<Candidate> candidates) {
    List<CameraSpec> cameras =
        candidates.stream().map(candidate -> candidate.camera("new")).toList();
    int[][] covered = problem.sight().covered(cameras, problem.request().reading());
    return IntStream.range(0, covered.length)
        .mapToObj(i -> new CoveringCamera(candidates.get(i), covered[i]))
        .collect(Collectors.toCollection(ArrayList::new));
  }

  /** Returns the candidates to which one can be turned, tilted or moved in a single step. */
  private static List<Candidate> moves(
      PlacementProblem problem, Candidate candidate, double turn, List<Point> points) {
    Mounting mount = candidate.mount();
    boolean tilts = Candidates.canTilt(problem.demand().site(), candidate.optics());
    Stream<Mounting> turned = DoubleStream.of(-turn, turn).mapToObj(mount::turnedBy);
    Stream<Mounting> tilted =
        DoubleStream.of(mount.tilt() - turn, mount.tilt() + turn)
            .filter(tilt -> tilts && Math.abs(tilt) <= 90)
            .mapToObj(mount::tiltedTo);
    Point position = mount.position();
    Stream<Mounting> moved =
        points.stream()
            .filter(point -> !point.equals(position))
            .sorted(Comparator.comparingDouble(point -> distance(point, position)))
            .limit(NEAREST_POINTS)
            .map(mount::movedTo);
    return Stream.of(turned, tilted, moved).flatMap(mounts -> mounts).map(candidate::on).toList();
  }

  private static double distance(Point point, Point position) {
    return Math.hypot(point.x() - position.x(), point.y() - position.y());
  }

  private static void change(int[] counts, CoveringCamera camera, int difference) {
    Arrays.stream(camera.covered).forEach(point -> counts[point] += difference);
  }
}
