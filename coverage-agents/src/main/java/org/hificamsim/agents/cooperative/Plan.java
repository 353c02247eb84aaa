package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/**
 * The way of each camera through its views up to the horizon, and what every view of a camera adds
 * to this plan if the camera sets out for it now: the worth of what it would detect on the best way
 * that begins there, beyond what the other cameras cover on their ways.
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

  /** The way of each camera, as in {@link Ways}. */
  private final int[][] plannedWays;

  /** Whether a way is planned, by camera. */
  private final boolean[] planned;

  private final WaySearch waySearch;

  /** The camera whose ways were searched for last, if nothing has changed since; or NONE. */
  private int searchedCamera = NONE;

  private Site site;

  /** What each move of a camera must add. */
  private double movePrice;

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
    plannedWays = new int[cameras][parameters.horizon()];
    planned = new boolean[cameras];
    waySearch = new WaySearch(parameters.horizon());
  }

  /** Begins a plan in which no camera has a view yet, from what is believed now. */
  void begin(NetworkView network, Belief belief) {
    tracks = belief.tracks();
    forecast.update(tracks, network.hidingWidth());
    coverage.clear(forecast.slots());
    site = belief.site();
    cellSight = site.cellSight();
    learnedSight = belief.learnedSight();
    learnedValues = belief.learnedValues();
    double[] expected = belief.searchMap().unseenTargets();
    boolean fits = unseenTargets.length == expected.length;
    unseenTargets = fits ? unseenTargets : new double[expected.length];
    System.arraycopy(expected, 0, unseenTargets, 0, unseenTargets.length);
    Arrays.fill(planned, false);
    searchedCamera = NONE;
    double knownPerCamera = tracks.sumOfWeights() / plannedWays.length;
    movePrice = hasDrives(network) ? parameters.hold() * knownPerCamera : 0;
    for (int camera = 0; camera < plannedWays.length; camera++) {
      if (network.online(camera)) {
        viewForecasts[camera].update(network, camera, belief, forecast);
      }
    }
  }

  /** The view that a camera is going to choose first, or {@link #NONE}. */
  int view(int camera) {
    return planned[camera] ? Ways.goal(plannedWays[camera]) : NONE;
  }

  /**
   * The best way of a camera that sets out for a view now. The next search overwrites the array.
   */
  int[] wayTo(NetworkView network, int camera, int view) {
    if (searchedCamera != camera) {
      gains(network, camera);
    }
    return waySearch.way(viewForecasts[camera].delay(view), view);
  }

  /** Plans a way for a camera, in place of the one planned before. */
  void choose(int camera, int[] way) {
    withdraw(camera);
    viewForecasts[camera].addTo(coverage, way);
    updateUnseenTargets(camera, way, false);
    System.arraycopy(way, 0, plannedWays[camera], 0, way.length);
    planned[camera] = true;
    searchedCamera = NONE;
  }

  /**
   * Plans no view for a camera. A camera that is going to choose again withdraws first, which saves
   * {@link #gains} the time to restore its old way.
   */
  void withdraw(int camera) {
    if (planned[camera]) {
      viewForecasts[camera].removeFrom(coverage, plannedWays[camera]);
      updateUnseenTargets(camera, plannedWays[camera], true);
      planned[camera] = false;
      searchedCamera = NONE;
    }
  }

  /** Reduces the unseen targets in the cells that a way looks at, or restores them. */
  private void updateUnseenTargets(int camera, int[] way, boolean restores) {
    for (int step = 0; step < way.length; step++) {
      if (Ways.isFirstLook(way, step)) {
        int[] cells = cellSight.cells(camera, way[step]);
        float[] chances = cellSight.chances(camera, way[step]);
        for (int i = 0; i < cells.length; i++) {
          double left = remainingShare(camera, cells[i], chances[i]);
          double targets = unseenTargets[cells[i]];
          unseenTargets[cells[i]] = restores ? targets / left : targets * left;
        }
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
   * Returns, for each view of a camera, what the best way that sets out for it now adds to the ways
   * of the others, 0 or more. The next call overwrites the array.
   */
  double[] gains(NetworkView network, int camera) {
    boolean wasPlanned = planned[camera];
    withdraw(camera);
    int views = network.views(camera);
    gains = gains.length < views ? new double[views] : gains;
    double[] rewards = waySearch.begin(site.travelTimes(camera));
    viewForecasts[camera].addRewards(forecast, coverage, rewards);
    for (int view = 0; view < views; view++) {
      addRewardsBeyondTracks(camera, view, views, rewards);
    }
    waySearch.solve(movePrice);
    int present = network.view(camera);
    for (int view = 0; view < views; view++) {
      double value = waySearch.value(viewForecasts[camera].delay(view), view);
      gains[view] = Math.max(0, view == present ? value : value - movePrice);
    }
    restore(camera, wasPlanned);
    searchedCamera = camera;
    return gains;
  }

  /** Whether any camera has drives, which wear; those of CamSim's worlds have none. */
  private static boolean hasDrives(NetworkView network) {
    boolean found = false;
    for (int camera = 0; camera < network.cameras() && !found; camera++) {
      found =
          Double.isFinite(network.turnInStep(camera))
              || Double.isFinite(network.zoomInStep(camera));
    }
    return found;
  }

  /** Spreads the gain of a view over the steps in which the camera can see through it. */
  private void addRewardsBeyondTracks(int camera, int view, int views, double[] rewards) {
    int delay = viewForecasts[camera].delay(view);
    double gain = gainBeyondTracks(camera, view) / forecast.sumOfDiscountsFrom(delay);
    for (int step = delay; step < forecast.horizon(); step++) {
      rewards[step * views + view] += gain * forecast.discount(step);
    }
  }

  private void restore(int camera, boolean wasPlanned) {
    if (wasPlanned) {
      choose(camera, plannedWays[camera]);
    }
  }

  /** Fills in what each view of a camera adds beyond the targets that are tracked. */
  void gainsBeyondTracks(NetworkView network, int camera, double[] viewGains) {
    boolean wasPlanned = planned[camera];
    withdraw(camera);
    for (int view = 0; view < network.views(camera); view++) {
      viewGains[view] = gainBeyondTracks(camera, view);
    }
    restore(camera, wasPlanned);
  }

  /** Fills in which known and unseen targets each view of a camera promises. */
  void fillOutlook(int camera, ViewOutlook outlook) {
    boolean wasPlanned = planned[camera];
    withdraw(camera);
    viewForecasts[camera].addTo(outlook, forecast, coverage);
    for (int view = 0; view < outlook.views(); view++) {
      boolean inTime = arrivesInTime(camera, view);
      outlook.setUnseen(view, inTime ? unseenTargetsIn(camera, view) : 0);
    }
    restore(camera, wasPlanned);
  }

  /** The number of steps up to the horizon; later steps count less, by their discount. */
  double discountedSteps() {
    return forecast.sumOfDiscountsFrom(0);
  }

  /** The gain of a view by unseen targets, and by the learned value of the view. */
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

  /** The expected detections of a camera in each of its views. */
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
   * Returns the view with the greatest gain; among views with equal gains the present one, or else
   * the first of those that are reached soonest.
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
