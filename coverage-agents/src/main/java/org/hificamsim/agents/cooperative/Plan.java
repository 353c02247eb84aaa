package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/**
 * Which view each camera is going to choose, and what every view of a camera adds to that: the
 * worth of what it would detect from when it gets there up to the horizon, beyond what the other
 * cameras cover as planned.
 *
 * <p>What a view adds of targets that nobody sees are those expected in the cells that it looks at,
 * as far as no other camera is going to look there.
 */
final class Plan {
  /** No view. */
  static final int NONE = -1;

  private static final double TIE = 1e-9;

  private final Parameters parameters;
  private final Forecast forecast;
  private final PlannedCoverage coverage;
  private final ViewForecast[] outlooks; // of each camera
  private final int[] planned; // view of each camera, or NONE
  private double[] unseen = {}; // by cell: targets that nobody looks at, if all do as planned
  private double[] gains = {};
  private CellSight cells;
  private TargetTracks tracks;
  private LearnedSight learned;
  private LearnedValues values;

  Plan(Parameters parameters, Worth worth, int cameras) {
    this.parameters = parameters;
    forecast = new Forecast(parameters);
    coverage = new PlannedCoverage(worth);
    outlooks = new ViewForecast[cameras];
    Arrays.setAll(outlooks, camera -> new ViewForecast());
    planned = new int[cameras];
    Arrays.fill(planned, NONE);
  }

  /** Begins a plan in which no camera has a view yet, from what is believed now. */
  void begin(NetworkView network, Belief belief) {
    tracks = belief.tracks();
    forecast.update(tracks);
    coverage.clear(forecast.slots());
    cells = belief.site().cells();
    learned = belief.learned();
    values = belief.values();
    double[] expected = belief.map().unseen();
    unseen = unseen.length == expected.length ? unseen : new double[expected.length];
    System.arraycopy(expected, 0, unseen, 0, unseen.length);
    Arrays.fill(planned, NONE);
    for (int camera = 0; camera < planned.length; camera++) {
      if (network.online(camera)) {
        outlooks[camera].update(network, camera, belief, forecast);
      }
    }
  }

  /** The view that is planned for a camera; -1 for none. */
  int view(int camera) {
    return planned[camera];
  }

  /** Plans a view for a camera in place of the one before. */
  void choose(int camera, int view) {
    withdraw(camera);
    apply(camera, view, true);
    planned[camera] = view;
  }

  private void withdraw(int camera) {
    if (planned[camera] != NONE) {
      apply(camera, planned[camera], false);
      planned[camera] = NONE;
    }
  }

  private void apply(int camera, int view, boolean added) {
    ViewForecast outlook = outlooks[camera];
    outlook.cover(view, coverage, added);
    if (outlook.delay(view) < forecast.horizon()) {
      int[] seen = cells.cells(camera, view);
      float[] chances = cells.chances(camera, view);
      for (int i = 0; i < seen.length; i++) {
        double left = SearchMap.leftAfterLook(chances[i] * learned.share(camera, seen[i]));
        unseen[seen[i]] = added ? unseen[seen[i]] * left : unseen[seen[i]] / left;
      }
    }
  }

  /** What each view of a camera adds to those of the others; from now on none is planned for it. */
  double[] gains(NetworkView network, int camera) {
    withdraw(camera);
    int views = network.views(camera);
    gains = gains.length < views ? new double[views] : gains;
    outlooks[camera].gains(forecast, coverage, gains);
    for (int view = 0; view < views; view++) {
      gains[view] = Math.max(0, gains[view] + beyond(camera, view));
    }
    return gains;
  }

  /** What a view adds beyond known targets: those that nobody sees, and what was learned. */
  private double beyond(int camera, int view) {
    int delay = outlooks[camera].delay(view);
    if (delay >= forecast.horizon()) {
      return 0;
    }
    double steps = forecast.weightFrom(delay);
    return parameters.search() * steps * unseen(camera, view)
        + values.correction(camera, view, steps);
  }

  private double unseen(int camera, int view) {
    int[] seen = cells.cells(camera, view);
    float[] chances = cells.chances(camera, view);
    double sum = 0;
    for (int i = 0; i < seen.length; i++) {
      sum += unseen[seen[i]] * chances[i] * learned.share(camera, seen[i]);
    }
    return sum;
  }

  /** What views of a camera add beyond known targets. */
  void search(NetworkView network, int camera, double[] into) {
    int before = planned[camera];
    withdraw(camera);
    for (int view = 0; view < network.views(camera); view++) {
      into[view] = beyond(camera, view);
    }
    if (before != NONE) {
      choose(camera, before);
    }
  }

  /** What a camera would detect. */
  ViewForecast outlook(int camera) {
    return outlooks[camera];
  }

  /** The number of a slot's target and step, the same in all plans. */
  int key(int slot) {
    return tracks.at(slot / forecast.horizon()) * forecast.horizon() + forecast.step(slot);
  }

  /** What it is worth that k cameras detect what is in a slot. */
  double worth(int slot, int k) {
    return forecast.weight(slot) * coverage.worth(k);
  }

  /** What a view adds, of the camera that was last asked for. */
  double gain(int view) {
    return gains[view];
  }

  /**
   * The view of a camera that adds most to those of the others; from now on none is planned for it.
   * Of equally good ones it is the one that the camera chose last, or the one that takes least
   * time, the first of these.
   */
  int best(NetworkView network, int camera) {
    return best(network, camera, gains(network, camera));
  }

  /** The view of a camera for which a number is highest; of equal ones as above. */
  int best(NetworkView network, int camera, double[] gain) {
    int best = network.view(camera);
    for (int view = 0; view < network.views(camera); view++) {
      double more = gain[view] - gain[best];
      ViewForecast outlook = outlooks[camera];
      boolean tie = Math.abs(more) <= TIE && outlook.delay(view) < outlook.delay(best);
      best = more > TIE || tie ? view : best;
    }
    return best;
  }
}
