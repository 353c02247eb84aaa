package org.hificamsim.agents.voting;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;
import org.hificamsim.agents.toy.GeometricNetwork;
import org.hificamsim.agents.toy.ToyNetwork;
import org.junit.jupiter.api.Test;

class NearestCamerasTest {
  @Test
  void agreesWithSortingByDistance() {
    GeometricNetwork network =
        GeometricNetwork.random(new GeometricNetwork.Kind(30, 2, 1, 1, true, false, 20, 5), 1);
    network.switchCamera(7, false);
    for (int k : new int[] {0, 1, 4, 28, 100}) {
      NearestCameras nearest = new NearestCameras(network, k);
      assertEquals(0, nearest.count(7));
      for (int camera = 0; camera < 30; camera++) {
        if (camera != 7) {
          assertArrayEquals(sorted(network, camera, k), neighbours(nearest, camera));
        }
      }
    }
  }

  @Test
  void prefersLowerNumbersOfEquallyNearCameras() {
    ToyNetwork network = new ToyNetwork(0, 2, 2, 2, 2, 2);
    NearestCameras nearest = new NearestCameras(network, 3);
    assertArrayEquals(new int[] {1, 3, 0}, neighbours(nearest, 2));
  }

  private static int[] neighbours(NearestCameras nearest, int camera) {
    return IntStream.range(0, nearest.count(camera))
        .map(i -> nearest.neighbour(camera, i))
        .toArray();
  }

  private static int[] sorted(GeometricNetwork network, int camera, int k) {
    return Arrays.stream(IntStream.range(0, 30).boxed().toArray(Integer[]::new))
        .filter(other -> other != camera && network.online(other))
        .sorted(
            Comparator.comparingDouble(
                other ->
                    Math.hypot(
                        network.cameraX(other) - network.cameraX(camera),
                        network.cameraY(other) - network.cameraY(camera))))
        .limit(k)
        .mapToInt(Integer::intValue)
        .toArray();
  }
}
