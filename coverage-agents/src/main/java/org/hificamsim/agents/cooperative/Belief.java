package org.hificamsim.agents.cooperative;

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
  private static final double FIRST_SIZE = 1; // metres
  private static final double NEW_SIZE = 0.2; // change of the mean size that cells are found for
  private static final double MAX_SPREAD = 0.8;

  private final Grid grid;
  private final SiteSight sight;
  private final TargetTracks tracks;
  private final CellSight cells;
  private final SearchMap map;
  private final boolean[] free;
  private final double[] chances; // room for those of a camera
  private double sizes;
  private long sized;
  private double cellSize = Double.NaN;

  Belief(Parameters parameters, NetworkView network) {
    int cameras = network.cameras();
    sight = new SiteSight(network.obstacles(), cameras);
    grid = Grid.over(network.field(), parameters.cells());
    free = new boolean[grid.cells()];
    for (int cell = 0; cell < free.length; cell++) {
      free[cell] = sight.isFree(grid.x(cell, 0.5), grid.y(cell, 0.5));
    }
    tracks = new TargetTracks(parameters, sight, network.targets());
    cells = new CellSight(grid, cameras);
    map = new SearchMap(parameters, grid, free, cameras);
    chances = new double[IntStream.range(0, cameras).map(network::views).max().orElse(0)];
  }

  /** A step begins: what is known of cameras, and where targets have gone. */
  void begin(NetworkView network) {
    double size = sized == 0 ? FIRST_SIZE : sizes / sized;
    if (sight.refresh(network) || !(Math.abs(size - cellSize) <= NEW_SIZE * cellSize)) {
      cellSize = size;
      cells.find(network, sight, free, size);
    }
    tracks.step();
  }

  /**
   * Takes in what a camera says.
   *
   * @param sent the step in which it said it
   */
  void receive(NetworkView network, Report report, long sent) {
    for (int i = 0; i < report.count(); i++) {
      double size = report.size(i) > 0 ? report.size(i) : FIRST_SIZE;
      sizes += size;
      sized++;
      tracks.see(report.target(i), sent, network.step(), report.x(i), report.y(i), size);
    }
    if (report.view() >= 0) {
      map.look(
          cells.cells(report.camera(), report.view()),
          cells.chances(report.camera(), report.view()));
    }
  }

  /** All reports of the step are in: what they should have seen and do not, and what is lost. */
  void end(NetworkView network) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      int view = network.online(camera) ? network.seeing(camera) : -1;
      if (view >= 0) {
        miss(network, camera, view);
      }
    }
    double known = 0;
    for (int i = 0; i < tracks.count(); i++) {
      int track = tracks.at(i);
      known += tracks.weight(track);
      if (tracks.seenAt(track) == network.step()) {
        map.sight(tracks.x(track), tracks.y(track));
      }
    }
    tracks.forget(network.step(), map);
    map.step(Math.min(MAX_SPREAD, tracks.meanWay() / grid.side()), known);
  }

  private void miss(NetworkView network, int camera, int view) {
    for (int i = 0; i < tracks.count(); i++) {
      int track = tracks.at(i);
      double x = tracks.x(track);
      double y = tracks.y(track);
      if (tracks.seenAt(track) < network.step()
          && sight.chances(network, camera, x, y, tracks.size(track), chances)) {
        map.absorb(x, y, tracks.miss(track, chances[view]));
      }
    }
  }

  /** Tells a listener what is believed. */
  void tell(long now, BeliefListener listener) {
    for (int i = 0; i < tracks.count(); i++) {
      int track = tracks.at(i);
      double spread = (now - tracks.seenAt(track)) * tracks.meanWay();
      listener.followed(tracks.x(track), tracks.y(track), tracks.weight(track), spread);
    }
    for (int cell = 0; cell < free.length; cell++) {
      listener.unseen(grid.x(cell, 0.5), grid.y(cell, 0.5), map.unseen()[cell]);
    }
  }

  SiteSight sight() {
    return sight;
  }

  TargetTracks tracks() {
    return tracks;
  }

  CellSight cells() {
    return cells;
  }

  SearchMap map() {
    return map;
  }
}
