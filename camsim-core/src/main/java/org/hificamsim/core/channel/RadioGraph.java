package org.hificamsim.core.channel;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;

/**
 * Which cameras receive each other, and the shortest ways over others to those that do not. Of
 * equally short ones, the way that is over the cameras with lower numbers counts.
 */
final class RadioGraph {
  private static final int NONE = -1;
  private static final int MOST = 2_000;

  private final Stations stations;
  private final double range;
  private final int[][] neighbours;
  private final int[][] before; // by sender: the camera before each on its way
  private int revision;

  RadioGraph(Stations stations, double range) {
    if (stations.cameras() > MOST) {
      throw InputException.of(
          "channel: range with %s cameras, expected at most %s", stations.cameras(), MOST);
    }
    this.stations = stations;
    this.range = range;
    neighbours = new int[stations.cameras()][];
    before = new int[stations.cameras()][];
    find();
  }

  private void find() {
    revision = stations.revision();
    Arrays.fill(before, null);
    Arrays.setAll(
        neighbours,
        camera ->
            IntStream.range(0, neighbours.length).filter(other -> hear(camera, other)).toArray());
  }

  private boolean hear(int camera, int other) {
    double dx = stations.cameraX(camera) - stations.cameraX(other);
    double dy = stations.cameraY(camera) - stations.cameraY(other);
    return stations.online(camera) && stations.online(other) && dx * dx + dy * dy <= range * range;
  }

  /** The camera before {@code to} on the way from a camera; -1 where there is no way. */
  int before(int from, int to) {
    if (revision != stations.revision()) {
      find();
    }
    if (before[from] == null) {
      before[from] = ways(from);
    }
    return before[from][to];
  }

  private int[] ways(int from) {
    int[] last = new int[neighbours.length];
    Arrays.fill(last, NONE);
    int[] reached = new int[neighbours.length];
    reached[0] = from;
    int count = 1;
    for (int i = 0; i < count; i++) {
      for (int next : neighbours[reached[i]]) {
        if (next != from && last[next] == NONE) {
          last[next] = reached[i];
          reached[count++] = next;
        }
      }
    }
    return last;
  }
}
