package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/**
 * The view that each camera is going to choose, and what every view of a camera adds to this plan:
 * the worth of what it would detect, from the step of its arrival up to the horizon, beyond what
 * the other cameras cover as planned.
 *
 * <p>Unseen targets count as well: those expected in the cells that a view looks at, as far as no
 * other camera is going to look there.
 */
final class Plan {
  /** No view. */
  static final int NONE = -1;

  private static final double TIE = 1e-9;

  private final Parameters parameters;
  private final Forecast forecast;
  private final PlannedCoverage coverage;
  private final ViewForecast[] viewForecasts;
  private final int[] plannedViews;
  private double[] unseenTargets = {};
  private double[] gains = {};
  private CellSight cellSight;
  private TargetTracks tracks;
  private LearnedSight learnedSight;
  private LearnedValues learnedValues;

  Plan(Parameters parameters, Worth worth, int cameras) {
    this.parameters = parameters;
    forecast = new Forecast(parameters);
    coverage = new PlannedCoverage(worth);
    viewForecasts = new ViewForecast[cameras];
    Arrays.setAll(viewForecasts, camera -> new ViewForecast());
    plannedViews = new int[cameras];
    Arrays.fill(plannedViews, NONE);
  }

  /** Begins a plan in which no camera has a view yet, from what is believed now. */
  void begin(NetworkView network, Belief belief) {
    tracks = belief.tracks();
    forecast.update(tracks);
    coverage.clear(forecast.slots());
    cellSight = belief.site().cellSight();
    learnedSight = belief.learnedSight();
    learnedValues = belief.learnedValues();
    double[] expected = belief.searchMap().unseenTargets();
    boolean fits = unseenTargets.length == expected.length;
    unseenTargets = fits ? unseenTargets : new double[expected.length];
    System.arraycopy(expected, 0, unseenTargets, 0, unseenTargets.length);
    Arrays.fill(plannedViews, NONE);
    for (int camera = 0; camera < plannedViews.length; camera++) {
      if (network.online(camera)) {
        viewForecasts[camera].update(network, camera, belief, forecast);
      }
    }
  }

  /** The view that is planned for a camera, or {@link #NONE}. */
  int view(int camera) {
    return plannedViews[camera];
  }

  /** Plans a view for a camera, in place of the one planned before. */
  void choose(int camera, int view) {
    withdraw(camera);
    cover(camera, view);
    plannedViews[camera] = view;
  }

  /**
   * Plans no view for a camera. A camera that is going to choose again withdraws first, which saves
   * {@link #gains} the time to restore its old view.
   */
  void withdraw(int camera) {
    if (plannedViews[camera] != NONE) {
      uncover(camera, plannedViews[camera]);
      plannedViews[camera] = NONE;
    }
  }

  private void cover(int camera, int view) {
    viewForecasts[camera].addTo(coverage, view);
    if (arrivesInTime(camera, view)) {
      int[] cells = cellSight.cells(camera, view);
      float[] chances = cellSight.chances(camera, view);
      for (int i = 0; i < cells.length; i++) {
        unseenTargets[cells[i]] *= remainingShare(camera, cells[i], chances[i]);
      }
    }
  }

  private void uncover(int camera, int view) {
    viewForecasts[camera].removeFrom(coverage, view);
    if (arrivesInTime(camera, view)) {
      int[] cells = cellSight.cells(camera, view);
      float[] chances = cellSight.chances(camera, view);
      for (int i = 0; i < cells.length; i++) {
        unseenTargets[cells[i]] /= remainingShare(camera, cells[i], chances[i]);
      }
    }
  }

  private boolean arrivesInTime(int camera, int view) {
    return viewForecasts[camera].delay(view) < forecast.horizon();
  }

  private double remainingShare(int camera, int cell, float chance) {
    return SearchMap.leftAfterLook(chance * learnedSight.share(camera, cell));
  }

  /**
   * Returns what each view of a camera adds to the views of the others, 0 or more. The next call
   * overwrites the array.
   */
  double[] gains(NetworkView network, int camera) {
    int plannedView = plannedViews[camera];
    withdraw(camera);
    int views = network.views(camera);
    gains = gains.length < views ? new double[views] : gains;
    viewForecasts[camera].gains(forecast, coverage, gains);
    for (int view = 0; view < views; view++) {
      gains[view] = Math.max(0, gains[view] + gainBeyondTracks(camera, view));
    }
    restore(camera, plannedView);
    return gains;
  }

  private void restore(int camera, int plannedView) {
    if (plannedView != NONE) {
      choose(camera, plannedView);
    }
  }

  /** Fills in what each view of a camera adds beyond the targets that are tracked. */
  void gainsBeyondTracks(NetworkView network, int camera, double[] viewGains) {
    int plannedView = plannedViews[camera];
    withdraw(camera);
    for (int view = 0; view < network.views(camera); view++) {
      viewGains[view] = gainBeyondTracks(camera, view);
    }
    restore(camera, plannedView);
  }

  /** What a view adds by targets that nobody sees, and by what was learned of the view. */
  private double gainBeyondTracks(int camera, int view) {
    if (!arrivesInTime(camera, view)) {
      return 0;
    }
    double stepWeight = forecast.sumOfDiscountsFrom(viewForecasts[camera].delay(view));
    return parameters.search() * stepWeight * unseenTargetsIn(camera, view)
        + learnedValues.correction(camera, view, stepWeight);
  }

  private double unseenTargetsIn(int camera, int view) {
    int[] cells = cellSight.cells(camera, view);
    float[] chances = cellSight.chances(camera, view);
    double sum = 0;
    for (int i = 0; i < cells.length; i++) {
      sum += unseenTargets[cells[i]] * chances[i] * learnedSight.share(camera, cells[i]);
    }
    return sum;
  }

  /** What a camera would detect in each of its views. */
  ViewForecast viewForecast(int camera) {
    return viewForecasts[camera];
  }

  /** The number of a slot's target and step, which is the same in all plans. */
  int targetAndStep(int slot) {
    return tracks.track(slot / forecast.horizon()) * forecast.horizon() + forecast.step(slot);
  }

  /** The worth of k cameras that detect the target of a slot in its step. */
  double worth(int slot, int k) {
    return forecast.weight(slot) * coverage.worth(k);
  }

  /** Withdraws a camera and returns the view that adds most to the views of the others. */
  int best(NetworkView network, int camera) {
    withdraw(camera);
    return best(network, camera, gains(network, camera));
  }

  /**
   * Returns the view of a camera with the greatest gain. Of views with equal gains it is the
   * present one, unless others are reached sooner: then the first of those that are reached
   * soonest.
   */
  int best(NetworkView network, int camera, double[] viewGains) {
    ViewForecast viewForecast = viewForecasts[camera];
    int best = network.view(camera);
    for (int view = 0; view < network.views(camera); view++) {
      double difference = viewGains[view] - viewGains[best];
      boolean reachedSooner =
          Math.abs(difference) <= TIE && viewForecast.delay(view) < viewForecast.delay(best);
      best = difference > TIE || reachedSooner ? view : best;
    }
    return best;
  }
}
