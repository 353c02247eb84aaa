package org.hificamsim.agents.cooperative;

import blogspot.software_and_algorithms.stern_library.optimization.HungarianAlgorithm;
import java.util.Arrays;

/**
 * Finds the track to which each sighting belongs, in reports that do not identify targets: of all
 * assignments to tracks within reach, the one with the least sum of distances (global nearest
 * neighbour; Blackman and Popoli, 1999), by the Hungarian algorithm. A sighting that fits no track
 * is a new target. Allocates in each step.
 */
final class Association {
  /**
   * The greatest distance of a sighting from the predicted position of its track, in mean step
   * lengths for each step since the last sighting; a step length counts as at least a cell's side.
   */
  private static final double REACH = 3;

  /** The cost of a sighting at the limit of a track's reach or beyond. */
  private static final double TOO_FAR = 1;

  private final double cellSide;
  private final TargetTracks tracks;

  Association(Grid grid, TargetTracks tracks) {
    this.cellSide = grid.side();
    this.tracks = tracks;
  }

  /** Returns a copy of the report that names the track of each target. */
  SightingReport identifyTargets(SightingReport report, long now) {
    int[] numbers = new int[report.count()];
    Arrays.fill(numbers, SightingReport.UNIDENTIFIED);
    if (report.count() > 0 && tracks.count() > 0) {
      double[][] costs = costs(report, now);
      int[] matches = new HungarianAlgorithm(costs).execute();
      for (int i = 0; i < numbers.length; i++) {
        boolean fits = matches[i] >= 0 && costs[i][matches[i]] < TOO_FAR;
        numbers[i] = fits ? tracks.track(matches[i]) : SightingReport.UNIDENTIFIED;
      }
    }
    int next = 0;
    for (int i = 0; i < numbers.length; i++) {
      if (numbers[i] == SightingReport.UNIDENTIFIED) {
        numbers[i] = tracks.unusedNumber(next);
        next = numbers[i] + 1;
      }
    }
    return report.copy(numbers);
  }

  /** Returns the distances as shares of the track's reach, at most 1, by sighting and track. */
  private double[][] costs(SightingReport report, long now) {
    double[][] costs = new double[report.count()][tracks.count()];
    for (int i = 0; i < costs.length; i++) {
      for (int j = 0; j < costs[i].length; j++) {
        int track = tracks.track(j);
        double dx = report.x(i) - tracks.x(track, now - report.step());
        double dy = report.y(i) - tracks.y(track, now - report.step());
        costs[i][j] = Math.min(TOO_FAR, Math.hypot(dx, dy) / reach(track, report.step()));
      }
    }
    return costs;
  }

  private double reach(int track, long reportedAt) {
    double steps = Math.abs(reportedAt - tracks.seenAt(track));
    return cellSide / 2 + steps * REACH * Math.max(cellSide, tracks.meanStepLength());
  }
}
