package org.hificamsim.agents.cooperative;

import blogspot.software_and_algorithms.stern_library.optimization.HungarianAlgorithm;
import java.util.Arrays;

/**
 * Says which track each sighting is of in reports that name no targets: of the tracks within reach,
 * the assignment with the least sum of distances (global nearest neighbour; Blackman and Popoli,
 * 1999), found by the Hungarian algorithm. What fits no track is a new target. Allocates in each
 * step.
 */
final class Association {
  /** How far a target may be from where it should be, in mean ways of a step. */
  private static final double REACH = 3;

  private static final double TOO_FAR = 1; // in reaches

  private final double side; // of a cell, metres
  private final TargetTracks tracks;

  Association(Grid grid, TargetTracks tracks) {
    this.side = grid.side();
    this.tracks = tracks;
  }

  /** A report with the numbers of tracks for its targets. */
  SightingReport name(SightingReport report, long now) {
    int[] numbers = new int[report.count()];
    Arrays.fill(numbers, SightingReport.UNNAMED);
    if (report.count() > 0 && tracks.count() > 0) {
      double[][] costs = costs(report, now);
      int[] matches = new HungarianAlgorithm(costs).execute();
      for (int i = 0; i < numbers.length; i++) {
        boolean fits = matches[i] >= 0 && costs[i][matches[i]] < TOO_FAR;
        numbers[i] = fits ? tracks.at(matches[i]) : SightingReport.UNNAMED;
      }
    }
    int next = 0;
    for (int i = 0; i < numbers.length; i++) {
      if (numbers[i] == SightingReport.UNNAMED) {
        numbers[i] = tracks.unused(next);
        next = numbers[i] + 1;
      }
    }
    return report.copy(numbers);
  }

  /** By sighting and track: how far it is from where it should be, in reaches, 1 at most. */
  private double[][] costs(SightingReport report, long now) {
    double[][] costs = new double[report.count()][tracks.count()];
    for (int i = 0; i < costs.length; i++) {
      for (int j = 0; j < costs[i].length; j++) {
        int track = tracks.at(j);
        double dx = report.x(i) - tracks.x(track, now - report.step());
        double dy = report.y(i) - tracks.y(track, now - report.step());
        costs[i][j] = Math.min(TOO_FAR, Math.hypot(dx, dy) / reach(track, report.step()));
      }
    }
    return costs;
  }

  private double reach(int track, long sent) {
    double steps = Math.abs(sent - tracks.seenAt(track));
    return side / 2 + steps * REACH * Math.max(side, tracks.meanWay());
  }
}
