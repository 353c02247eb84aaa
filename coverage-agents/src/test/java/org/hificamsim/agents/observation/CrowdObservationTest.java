package org.hificamsim.agents.observation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.hificamsim.agents.baseline.RandomZoomPolicy;
import org.hificamsim.agents.toy.RealWorld;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.junit.jupiter.api.Test;

/**
 * Tests observations of three cameras that see while they move, among many targets, some equally
 * near.
 */
class CrowdObservationTest {
  private static final ObservationLayout LAYOUT = new ObservationLayout(3, 2, false);
  private static final String OPTICS =
      "<optics name='o' hfov='20 40 80' reach='12' pan='0 90' pan_speed='30' moving='sees'/>";

  private static String camera(String name, double x, double y) {
    return "<camera name='%s' x='%s' y='%s' heading='0' viewing_angle='60' range='12' optics='o'/>"
        .formatted(name, x, y);
  }

  private static String cameras(double lastCameraX) {
    return OPTICS + camera("a", -8, 0) + camera("b", 8, 6) + camera("c", lastCameraX, 0);
  }

  /** Returns targets in pairs on both sides of the first camera's axis. */
  private static String targets() {
    StringBuilder elements = new StringBuilder();
    for (int name = 0; name < 24; name++) {
      double aside = (name % 2 == 0 ? 1 : -1) * (1 + name % 3) * 0.25;
      int row = name / 2;
      elements.append(
          "<object features='%s' x='%s' y='%s' heading='%s' speed='%s' size='0.5'/>"
              .formatted(name, -8 + aside, 11 - row, 15 * name, name < 12 ? 0 : 0.3));
    }
    return elements.toString();
  }

  @Test
  void ordersTargetsByDistanceThenNumber() {
    int[] compared = new int[1];
    run(
        new RandomZoomPolicy(),
        network -> {
          float[] out = new float[3 * LAYOUT.size()];
          Arrays.fill(out, 9); // older numbers, which must not stay
          new CameraObserver(network, LAYOUT).observe(network, out);
          for (int camera = 0; camera < 3; camera++) {
            compared[0] += assertTargets(network, camera, camera * LAYOUT.size(), out);
          }
        });
    assertTrue(compared[0] > 300, compared[0] + " targets");
  }

  private static int assertTargets(NetworkView network, int camera, int first, float[] out) {
    List<Integer> seen =
        IntStream.range(0, network.targets())
            .filter(target -> network.sees(camera, target))
            .boxed()
            .sorted(
                Comparator.<Integer>comparingDouble(
                        target -> Math.rint(network.distance(camera, target) * 1e9))
                    .thenComparing(Comparator.naturalOrder()))
            .limit(LAYOUT.targets())
            .toList();
    for (int i = 0; i < LAYOUT.targets(); i++) {
      int at = first + LAYOUT.firstTarget() + i * ObservationLayout.TARGET.size();
      assertEquals(i < seen.size() ? 1 : 0, out[at], "target " + i);
      if (i < seen.size()) {
        double distance = network.distance(camera, seen.get(i));
        double bearing = network.bearing(camera, seen.get(i));
        assertEquals(distance * Math.cos(bearing) / 12, out[at + 1], 1e-6);
        assertEquals(distance * Math.sin(bearing) / 12, out[at + 2], 1e-6);
      } else {
        assertArrayEquals(new float[6], Arrays.copyOfRange(out, at, at + 6));
      }
    }
    return seen.size();
  }

  @Test
  void ownNumbersDescribeChosenAndPresentView() {
    int[] moving = new int[1];
    run(
        new RandomZoomPolicy(),
        network -> {
          float[] out = observe(network);
          for (int camera = 0; camera < 3; camera++) {
            int at = camera * LAYOUT.size();
            int goal = network.view(camera);
            int seeing = network.seeing(camera);
            assertEquals(goal < 3 ? 0 : 0.5, out[at + ObservationLayout.at("goal_pan")]);
            assertEquals(goal % 3 / 2.0, out[at + ObservationLayout.at("goal_zoom")]);
            assertEquals(seeing < 3 ? 0 : 0.5, out[at + ObservationLayout.at("pan")]);
            assertEquals(seeing % 3 / 2.0, out[at + ObservationLayout.at("zoom")]);
            double angle = network.zoom(camera, seeing).viewingAngle() / (2 * Math.PI);
            assertEquals(angle, out[at + ObservationLayout.at("angle")], 1e-7);
            moving[0] += seeing == goal ? 0 : 1;
          }
        });
    assertTrue(moving[0] > 20, moving[0] + " moving");
  }

  @Test
  void ordersNeighboursByDistance() {
    run(
        new RandomZoomPolicy(),
        network -> {
          float[] out = observe(network);
          int at = LAYOUT.ownSize();
          float[] expected = {
            2 / 16f, 0, network.detected(2) / 24f, 1, 6 / 16f, network.detected(1) / 24f
          };
          assertArrayEquals(expected, Arrays.copyOfRange(out, at, at + 6), 1e-7f);
        });
  }

  @Test
  void clearsNumbersOfOfflineCameras() {
    String off = "<event timestep='0' participant='camera' event='error' name='a' duration='-1'/>";
    CheckingPolicy checking =
        new CheckingPolicy(
            new RandomZoomPolicy(),
            network -> {
              float[] out = new float[3 * LAYOUT.size()];
              Arrays.fill(out, 9);
              new CameraObserver(network, LAYOUT).observe(network, out);
              float[] first = Arrays.copyOf(out, LAYOUT.size());
              assertArrayEquals(new float[LAYOUT.size()], first);
            });
    RealWorld.run(cameras(-6) + targets() + "<events>" + off + "</events>", checking, 1).run(3);
  }

  @Test
  void observesNewPositionOfMovedCamera() {
    String move =
        "<event timestep='2' participant='camera' event='change' name='c' x='4' y='0'"
            + " heading='-1' viewing_angle='-1' range='-1'/>";
    int x = LAYOUT.size() * 2 + 1;
    float[] seen = new float[4];
    CameraObserver[] observer = new CameraObserver[1];
    CheckingPolicy checking =
        new CheckingPolicy(
            new RandomZoomPolicy(),
            network -> {
              observer[0] = observer[0] == null ? new CameraObserver(network, LAYOUT) : observer[0];
              float[] out = new float[3 * LAYOUT.size()];
              observer[0].observe(network, out);
              seen[(int) network.step()] = out[x];
            });
    RealWorld.run(cameras(-6) + targets() + "<events>" + move + "</events>", checking, 1).run(4);
    assertArrayEquals(new float[] {-0.75f, -0.75f, 0.5f, 0.5f}, seen);
  }

  @Test
  void worldsWithEqualCamerasShareNumbers() {
    NetworkView network = network(-6);
    NetworkView equal = network(-6);
    NetworkView moved = network(4);
    ViewFeatures features = new ViewFeatures(network, new ViewRows(network, LAYOUT));
    ObservationLayout other = new ObservationLayout(3, 1, false);
    assertTrue(features.areOf(equal, new ViewRows(equal, LAYOUT)));
    assertFalse(features.areOf(moved, new ViewRows(moved, LAYOUT)));
    assertFalse(features.areOf(equal, new ViewRows(equal, other)));
    CameraObserver first = new CameraObserver(network, LAYOUT);
    assertArrayEquals(observe(equal), observe(new CameraObserver(equal, LAYOUT, first), equal));
    assertArrayEquals(observe(moved), observe(new CameraObserver(moved, LAYOUT, first), moved));
    int lastCameraX = LAYOUT.size() * 2 + 1;
    assertNotEquals(observe(network)[lastCameraX], observe(moved)[lastCameraX]);
  }

  private static NetworkView network(double lastCameraX) {
    return RealWorld.run(cameras(lastCameraX) + targets(), new RandomZoomPolicy(), 1).network();
  }

  private static float[] observe(NetworkView network) {
    return observe(new CameraObserver(network, LAYOUT), network);
  }

  private static float[] observe(CameraObserver observer, NetworkView network) {
    float[] out = new float[3 * LAYOUT.size()];
    observer.observe(network, out);
    return out;
  }

  private static void run(ZoomPolicy policy, Consumer<NetworkView> check) {
    RealWorld.run(cameras(-6) + targets(), new CheckingPolicy(policy, check), 1).run(200);
  }

  /** Observes the network before each decision of a policy. */
  private record CheckingPolicy(ZoomPolicy policy, Consumer<NetworkView> check)
      implements ZoomPolicy {
    @Override
    public String name() {
      return policy.name();
    }

    @Override
    public void begin(NetworkView network, SplittableRandom random) {
      policy.begin(network, random);
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      check.accept(network);
      policy.decide(network, views);
    }
  }
}
