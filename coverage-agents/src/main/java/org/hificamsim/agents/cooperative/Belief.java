package org.hificamsim.agents.cooperative;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.policy.BeliefListener;
import org.hificamsim.core.policy.NetworkView;

/**
 * What is believed of where targets are, from the reports that have arrived: tracks of those seen
 * lately, and a search map of those that nobody sees. Nobody says how many there are.
 *
 * <p>In each step {@link #begin}, then {@link #receive} for each report, then {@link #end}.
 */
final class Belief {
  private static final double UNKNOWN_SIZE = 1; // metres
  private static final double MAX_SPREAD = 0.8;

  private final Site site;
  private final TargetTracks tracks;
  private final SearchMap map;
  private final LearnedSight learned;
  private final LearnedValues values;
  private final Association association; // null where reports name targets
  private final double[] chances; // room for those of a camera
  private final List<SightingReport> arrived = new ArrayList<>();

  Belief(Parameters parameters, Worth worth, Site site, NetworkView network) {
    this.site = site;
    tracks = new TargetTracks(parameters, site.map(), parameters.named() ? network.targets() : 0);
    association = parameters.named() ? null : new Association(site.grid(), tracks);
    boolean sight = parameters.learn() == Parameters.Learn.SIGHT;
    learned = new LearnedSight(sight, site.grid(), network.cameras());
    int[] views = IntStream.range(0, network.cameras()).map(network::views).toArray();
    values = new LearnedValues(parameters, worth, views);
    map = new SearchMap(parameters, site.grid(), site.free(), network.cameras());
    chances = new double[IntStream.of(views).max().orElse(0)];
  }

  /** A step begins: targets have gone on. */
  void begin() {
    tracks.step();
    arrived.clear();
  }

  /** Takes in what a camera says. */
  void receive(NetworkView network, SightingReport arrival) {
    long now = network.step();
    SightingReport report = association == null ? arrival : association.name(arrival, now);
    for (int i = 0; i < report.count(); i++) {
      double size = report.size(i) > 0 ? report.size(i) : UNKNOWN_SIZE;
      if (tracks.see(report.target(i), report.step(), now, report.x(i), report.y(i), size)) {
        map.sight(report.x(i), report.y(i));
      }
    }
    if (report.view() >= 0) {
      arrived.add(report);
    }
  }

  /** All reports of the step are in: what they should have seen and did not is elsewhere. */
  void end(NetworkView network) {
    long now = network.step();
    for (int i = 0; i < arrived.size(); i++) {
      SightingReport report = arrived.get(i);
      int camera = report.camera();
      int[] looked = site.cells().cells(camera, report.view());
      map.look(looked, site.cells().chances(camera, report.view()), learned, camera);
      compare(network, report);
    }
    double known = 0;
    for (int i = 0; i < tracks.count(); i++) {
      known += tracks.weight(tracks.at(i));
    }
    tracks.forget(now, map);
    map.step(Math.min(MAX_SPREAD, tracks.meanWay() / site.grid().side()), known);
  }

  /**
   * Compares what a camera said in a step with what it should have seen; where targets were then
   * follows from how they move.
   */
  private void compare(NetworkView network, SightingReport report) {
    long ago = network.step() - report.step();
    for (int i = 0; i < tracks.count(); i++) {
      int track = tracks.at(i);
      double x = tracks.x(track, ago);
      double y = tracks.y(track, ago);
      int camera = report.camera();
      if (site.chances(network, camera, x, y, tracks.size(track), chances)) {
        double chance = chances[report.view()];
        miss(track, chance * learned.share(camera, x, y), report.step());
        boolean seen = report.has(track);
        learned.see(camera, x, y, chance * tracks.weight(track), seen);
        if (values.learns()) {
          int others = seenBy(track) - (seen ? 1 : 0);
          values.see(camera, chance, tracks.weight(track), others, seen);
        }
      }
    }
    values.learn(report.camera(), report.view());
  }

  private int seenBy(int track) {
    int cameras = 0;
    for (int i = 0; i < arrived.size(); i++) {
      cameras += arrived.get(i).has(track) ? 1 : 0;
    }
    return cameras;
  }

  private void miss(int track, double chance, long step) {
    if (tracks.seenAt(track) < step && chance > 0) {
      map.absorb(tracks.x(track), tracks.y(track), tracks.miss(track, Math.min(1, chance)));
    }
  }

  /** As {@link Site#chances}, corrected by what was learned. */
  boolean chances(NetworkView network, int camera, double x, double y, double size, double[] into) {
    boolean any = site.chances(network, camera, x, y, size, into);
    double share = any ? learned.share(camera, x, y) : 1;
    for (int view = 0; view < into.length && share != 1; view++) {
      into[view] = Math.min(1, share * into[view]);
    }
    return any;
  }

  /** How much of what the map lets a camera see in cells it does see. */
  LearnedSight learned() {
    return learned;
  }

  /** What views have been worth beyond what the map says. */
  LearnedValues values() {
    return values;
  }

  /** Tells a listener what is believed. */
  void tell(long now, BeliefListener listener) {
    for (int i = 0; i < tracks.count(); i++) {
      int track = tracks.at(i);
      double spread = (now - tracks.seenAt(track)) * tracks.meanWay();
      listener.followed(tracks.x(track), tracks.y(track), tracks.weight(track), spread);
    }
    Grid grid = site.grid();
    for (int cell = 0; cell < grid.cells(); cell++) {
      if (site.free()[cell]) {
        listener.unseen(grid.x(cell, 0.5), grid.y(cell, 0.5), map.unseen()[cell]);
      }
    }
  }

  Site site() {
    return site;
  }

  TargetTracks tracks() {
    return tracks;
  }

  SearchMap map() {
    return map;
  }
}
