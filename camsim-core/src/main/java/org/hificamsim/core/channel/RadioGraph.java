package org.hificamsim.core.channel;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;

/**
 * The cameras that receive each other directly, and the shortest paths over others between those
 * that do not. If paths are equally short, the one over cameras with lower numbers is taken.
 */
final class RadioGraph {
  private static final int NONE = -1;
  private static final int MAX_CAMERAS = 2_000;

  private final Stations stations;
  private final double range;
  private final int[][] neighbours;

  /** The last camera before the receiver on the path, by sender and receiver. */
  private final int[][] predecessors;

  private int revision;

  RadioGraph(Stations stations, double range) {
    if (stations.cameras() > MAX_CAMERAS) {
      throw InputException.of(
          "channel: range with %s cameras, expected at most %s", stations.cameras(), MAX_CAMERAS);
    }
    this.stations = stations;
    this.range = range;
    neighbours = new int[stations.cameras()][];
    predecessors = new int[stations.cameras()][];
    findNeighbours();
  }

  private void findNeighbours() {
    revision = stations.revision();
    Arrays.fill(predecessors, null);
    Arrays.setAll(
        neighbours,
        camera ->
            IntStream.range(0, neighbours.length)
                .filter(other -> receiveEachOther(camera, other))
                .toArray());
  }

  private boolean receiveEachOther(int camera, int other) {
    double dx = stations.cameraX(camera) - stations.cameraX(other);
    double dy = stations.cameraY(camera) - stations.cameraY(other);
    return stations.online(camera) && stations.online(other) && dx * dx + dy * dy <= range * range;
  }

  /** The last camera before {@code to} on the path from a camera; -1 if there is no path. */
  int predecessor(int from, int to) {
    if (revision != stations.revision()) {
      findNeighbours();
    }
    if (predecessors[from] == null) {
      predecessors[from] = shortestPaths(from);
    }
    return predecessors[from][to];
  }

  /**
   * Returns for each receiver the camera before it on the shortest path from a camera (breadth-
   * first).
   */
  private int[] shortestPaths(int from) {
    int[] previous = new int[neighbours.length];
    Arrays.fill(previous, NONE);
    int[] reached = new int[neighbours.length];
    reached[0] = from;
    int count = 1;
    for (int i = 0; i < count; i++) {
      for (int next : neighbours[reached[i]]) {
        if (next != from && previous[next] == NONE) {
          previous[next] = reached[i];
          reached[count++] = next;
        }
      }
    }
    return previous;
  }
}
