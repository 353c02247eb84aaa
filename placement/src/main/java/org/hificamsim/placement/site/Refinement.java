package org.hificamsim.placement.site;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.placement.site.Candidates.Candidate;

/**
 * Moves chosen cameras to headings, tilts and places between the candidates', by shrinking steps
 * (pattern search), as long as more of the demand is met. Lens, height and price stay.
 *
 * @param places where cameras can be, ever closer together, one list for each step
 * @param stop ends it at the next opportunity
 */
public record Refinement(List<List<Point>> places, int threads, BooleanSupplier stop) {
  private static final int NEAR = 6; // places to try: the next ones on both sides of a wall
  private static final double LEAST = 1e-9; // gain, as a share

  private record Mounted(Candidate camera, int[] covered) {}

  /** The same cameras, moved. */
  List<Candidate> of(PlacementProblem problem, List<Candidate> chosen) {
    int[] counts = problem.keptCounts().clone();
    List<Mounted> now = mounted(problem, chosen);
    now.forEach(one -> add(counts, one, 1));
    double least = LEAST * problem.whole().total();
    for (int step = 0; step < places.size(); step++) {
      double turn = Candidates.TURN / Math.pow(2, step + 1);
      List<Point> grid = places.get(step);
      Map<Candidate, List<Mounted>> known = new ConcurrentHashMap<>();
      Function<Candidate, List<Mounted>> around =
          one -> mounted(problem, near(problem, one, turn, grid));
      Function<Mounted, List<Mounted>> moves =
          one -> stop.getAsBoolean() ? List.of() : known.computeIfAbsent(one.camera, around);
      for (boolean moved = true; moved && !stop.getAsBoolean(); ) {
        List<List<Mounted>> others = Parallel.map(now, threads, moves);
        moved = false;
        for (int i = 0; i < others.size(); i++) {
          add(counts, now.get(i), -1);
          for (Mounted other : others.get(i)) {
            double gain = problem.whole().gain(counts, other.covered);
            if (gain > problem.whole().gain(counts, now.get(i).covered) + least) {
              now.set(i, other);
              moved = true;
            }
          }
          add(counts, now.get(i), 1);
        }
      }
    }
    return now.stream().map(Mounted::camera).toList();
  }

  private static List<Mounted> mounted(PlacementProblem problem, List<Candidate> cameras) {
    List<CameraSpec> specs = cameras.stream().map(one -> one.camera("new")).toList();
    int[][] covered = problem.sight().covered(specs, problem.reading());
    List<Mounted> all = new ArrayList<>();
    cameras.forEach(one -> all.add(new Mounted(one, covered[all.size()])));
    return all;
  }

  private static List<Candidate> near(
      PlacementProblem problem, Candidate one, double turn, List<Point> grid) {
    boolean tilts = problem.demand().site().hasHeights() && one.optics().law() == OpticsLaw.PINHOLE;
    Stream<Candidate> turned =
        DoubleStream.of(-turn, turn)
            .mapToObj(by -> one.moved(one.optics(), one.at(), one.tilt(), by));
    Stream<Candidate> tilted =
        DoubleStream.of(one.tilt() - turn, one.tilt() + turn)
            .filter(tilt -> tilts && Math.abs(tilt) <= 90)
            .mapToObj(tilt -> one.moved(one.optics(), one.at(), tilt, 0));
    Comparator<Point> byDistance =
        Comparator.comparingDouble(to -> Math.hypot(to.x() - one.at().x(), to.y() - one.at().y()));
    Stream<Candidate> placed =
        grid.stream()
            .filter(to -> !to.equals(one.at()))
            .sorted(byDistance)
            .limit(NEAR)
            .map(to -> one.moved(one.optics(), to, one.tilt(), 0));
    return Stream.of(turned, tilted, placed).flatMap(all -> all).toList();
  }

  private static void add(int[] counts, Mounted one, int by) {
    Arrays.stream(one.covered).forEach(sample -> counts[sample] += by);
  }
}
