package org.hificamsim.agents.cooperative;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.policy.BeliefListener;
import org.hificamsim.core.policy.NetworkView;

/**
 * The believed positions of targets, according to the reports that have arrived: tracks of targets
 * that were seen lately, and a search map of targets that no camera sees. The number of targets is
 * unknown.
 *
 * <p>In each step call {@link #begin}, then {@link #receive} for each report, then {@link #end}.
 */
final class Belief {
  private static final double MAX_SPREAD = 0.8;

  private final Site site;
  private final TargetTracks tracks;
  private final SearchMap searchMap;
  private final LearnedSight learnedSight;
  private final LearnedValues learnedValues;

  /** The assignment of sightings to tracks; null if reports identify targets. */
  private final Association association;

  private final IdentitySwitches identitySwitches;
  private final double[] viewChances;
  private final Hiding hiding = new Hiding();
  private final List<SightingReport> reports = new ArrayList<>();

  Belief(Parameters parameters, Worth worth, Site site, NetworkView network) {
    this.site = site;
    boolean identified = parameters.identified();
    tracks = new TargetTracks(parameters, site.map(), identified ? network.targets() : 0);
    association = identified ? null : new Association(site.grid(), tracks);
    identitySwitches = new IdentitySwitches(tracks, identified ? 0 : network.targets());
    boolean learnsSight = parameters.learn() == Parameters.Learn.SIGHT;
    learnedSight = new LearnedSight(learnsSight, site.grid(), network.cameras());
    int[] views = IntStream.range(0, network.cameras()).map(network::views).toArray();
    learnedValues = new LearnedValues(parameters, worth, views);
    // The number of targets is unknown: at first we expect as many as there are cameras.
    searchMap = new SearchMap(parameters, site.grid(), site.free(), network.cameras());
    viewChances = new double[IntStream.of(views).max().orElse(0)];
  }

  /** Begins a step: moves all tracked targets on. */
  void begin() {
    tracks.step();
    reports.clear();
  }

  /** Takes in the report of a camera. */
  void receive(NetworkView network, SightingReport received) {
    long now = network.step();
    SightingReport report =
        association == null ? received : association.identifyTargets(received, now);
    for (int i = 0; i < report.count(); i++) {
      if (tracks.see(report, i, now)) {
        searchMap.countSighting(report.x(i), report.y(i));
      }
    }
    if (association != null) {
      identitySwitches.count(report);
    }
    if (report.view() >= 0) {
      reports.add(report);
    }
  }

  /**
   * Ends a step: draws conclusions from what cameras should have seen, and did not. This waits
   * until all reports have been received, because a target that another camera saw is not missed.
   */
  void end(NetworkView network) {
    for (int i = 0; i < reports.size(); i++) {
      SightingReport report = reports.get(i);
      int camera = report.camera();
      int[] cells = site.cellSight().cells(camera, report.view());
      float[] chances = site.cellSight().chances(camera, report.view());
      searchMap.look(cells, chances, learnedSight, camera);
      compareWithTracks(network, report);
    }
    double knownTargets = tracks.sumOfWeights();
    tracks.forget(network.step(), searchMap);
    double spread = Math.min(MAX_SPREAD, tracks.meanStepLength() / site.grid().side());
    searchMap.step(spread, knownTargets);
  }

  /**
   * Compares what a camera reports of a step with what it should have seen, given where the tracked
   * targets were in that step.
   */
  private void compareWithTracks(NetworkView network, SightingReport report) {
    int camera = report.camera();
    long stepsAgo = network.step() - report.step();
    updateHiding(network, stepsAgo);
    for (int i = 0; i < tracks.count(); i++) {
      int track = tracks.track(i);
      double x = tracks.x(track, stepsAgo);
      double y = tracks.y(track, stepsAgo);
      if (site.chances(network, camera, x, y, tracks.size(track), viewChances)) {
        double chance =
            viewChances[report.view()]
                * hiding.visibleShare(network, camera, i, tracks.size(track));
        miss(track, chance * learnedSight.share(camera, x, y), report.step());
        boolean seen = report.has(track);
        learnedSight.learn(camera, x, y, chance * tracks.weight(track), seen);
        if (learnedValues.learns()) {
          int others = camerasThatSee(track) - (seen ? 1 : 0);
          learnedValues.compare(camera, chance, tracks.weight(track), others, seen);
        }
      }
    }
    learnedValues.learn(camera, report.view());
  }

  private void updateHiding(NetworkView network, long stepsAgo) {
    hiding.clear(network.hidingWidth(), stepsAgo * tracks.meanStepLength());
    for (int i = 0; i < tracks.count(); i++) {
      int track = tracks.track(i);
      hiding.add(tracks.x(track, stepsAgo), tracks.y(track, stepsAgo), tracks.weight(track));
    }
  }

  private int camerasThatSee(int track) {
    int cameras = 0;
    for (int i = 0; i < reports.size(); i++) {
      cameras += reports.get(i).has(track) ? 1 : 0;
    }
    return cameras;
  }

  /**
   * Takes in a miss, unless a camera, this one or another, saw the target in that step or later.
   */
  private void miss(int track, double chance, long step) {
    if (tracks.seenAt(track) < step && chance > 0) {
      double lost = tracks.miss(track, Math.min(1, chance));
      searchMap.absorb(tracks.x(track), tracks.y(track), lost);
    }
  }

  /** Computes {@link Site#chances}, corrected by what was learned of the camera's sight. */
  boolean chances(
      NetworkView network, int camera, double x, double y, double size, double[] chances) {
    boolean visible = site.chances(network, camera, x, y, size, chances);
    double share = visible ? learnedSight.share(camera, x, y) : 1;
    for (int view = 0; view < chances.length && share != 1; view++) {
      chances[view] = Math.min(1, share * chances[view]);
    }
    return visible;
  }

  /** The number of sightings so far that were taken for another target than before. */
  long identitySwitches() {
    return identitySwitches.count();
  }

  LearnedSight learnedSight() {
    return learnedSight;
  }

  LearnedValues learnedValues() {
    return learnedValues;
  }

  /** Reports all tracks, and the unseen targets expected in each cell, to a listener. */
  void report(long now, BeliefListener listener) {
    for (int i = 0; i < tracks.count(); i++) {
      int track = tracks.track(i);
      double spread = (now - tracks.seenAt(track)) * tracks.meanStepLength();
      listener.followed(tracks.x(track), tracks.y(track), tracks.weight(track), spread);
    }
    Grid grid = site.grid();
    for (int cell = 0; cell < grid.cells(); cell++) {
      if (site.free()[cell]) {
        listener.unseen(grid.x(cell, 0.5), grid.y(cell, 0.5), searchMap.unseenTargets()[cell]);
      }
    }
  }

  Site site() {
    return site;
  }

  TargetTracks tracks() {
    return tracks;
  }

  SearchMap searchMap() {
    return searchMap;
  }
}
