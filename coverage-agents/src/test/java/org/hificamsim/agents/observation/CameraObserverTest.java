package org.hificamsim.agents.observation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.agents.baseline.RandomZoomPolicy;
import org.hificamsim.agents.toy.RealWorld;
import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.junit.jupiter.api.Test;

/** Tests with two cameras at (-8, 0) and (8, 6); the first one looks along +y and can turn. */
class CameraObserverTest {
  private static final ObservationLayout LAYOUT = new ObservationLayout(2, 1, false);
  private static final String CAMERAS =
      "<optics name='o' hfov='30 60' reach='10' pan='0 90' pan_speed='40'/>"
          + "<camera name='a' x='-8' y='0' heading='0' viewing_angle='60' range='10' optics='o'/>"
          + "<camera name='b' x='8' y='6' heading='90' viewing_angle='60' range='10' optics='o'/>";
  private static final String TARGETS =
      target(1, -8, 5, 0.5) + target(2, -7, 2, 1) + target(3, -8, 9, 1) + target(4, 0, -15, 1);

  private static String target(int name, double x, double y, double size) {
    return "<object features='"
        + name
        + "' x='"
        + x
        + "' y='"
        + y
        + "' heading='0' speed='0' size='"
        + size
        + "'/>";
  }

  @Test
  void namesAreUnique() {
    List<String> names = LAYOUT.features().stream().map(Feature::name).toList();
    assertEquals(LAYOUT.size(), names.size());
    assertEquals(names.size(), names.stream().distinct().count());
  }

  @Test
  void observesOwnPositionAndHeading() {
    Observed observed = observe(RealWorld.always(1, 1), 1);
    assertEquals(1, observed.number("online"));
    assertEquals(-1, observed.number("x"));
    assertEquals(-0.375, observed.number("y"));
    assertEquals(0, observed.number("mounted_x"));
    assertEquals(1, observed.number("mounted_y"));
    assertEquals(1, observed.number("zoom"), "the widest");
    assertEquals(1 / 6.0, observed.number("angle"), 1e-7);
    assertEquals(1, observed.number("neighbour0_dx"));
    assertEquals(0.375, observed.number("neighbour0_dy"), 1e-7);
  }

  @Test
  void observesNearestTargetsFirst() {
    Observed observed = observe(RealWorld.always(1, 1), 1);
    assertEquals(0.2, observed.number("target0_ahead"), 1e-6);
    assertEquals(0.1, observed.number("target0_right"), 1e-6);
    assertEquals(0.5, observed.number("target1_ahead"), 1e-6);
    assertEquals(0, observed.number("target1_right"), 1e-6);
    assertEquals(0.5 / 5 / Math.toRadians(60), observed.number("target1_size"), 1e-6);
    assertEquals(1, observed.number("target1_confidence"));
    assertEquals(0.5, observed.number("target1_coverage"), "one camera of two, in the step before");
    assertEquals(0.75, observed.number("detected"), "three of four, in the step before");
  }

  @Test
  void numbersOfUnseenTargetsAreZero() {
    Observed observed = observe(RealWorld.always(3, 1), 4);
    assertEquals(0.5, observed.number("pan"), "turned to the right, where nothing is");
    assertEquals(0, observed.number("target0_seen"));
    assertEquals(0, observed.number("target0_ahead"));
  }

  @Test
  void movingCameraObservesItsGoalAndDuration() {
    Observed observed = observe(RealWorld.always(3, 1), 2);
    assertEquals(1, observed.number("moving"));
    assertEquals(1, observed.number("blind"));
    assertEquals(0.5, observed.number("goal_pan"));
    assertEquals(2 / 3.0, observed.number("way"), 1e-6);
    assertEquals(0, observed.number("target0_seen"));
  }

  @Test
  void tiltingCameraObservesHeightAndTilts() {
    ObservationLayout withHeights = new ObservationLayout(2, 1, true);
    String cameras =
        CAMERAS
            .replace("pan_speed='40'", "tilt='0 45' pan_speed='40'")
            .replace("heading='0'", "heading='0' z='4' tilt='9'");
    int widestAtSecondTilt = 3;
    WatchingPolicy watching =
        new WatchingPolicy(RealWorld.always(widestAtSecondTilt, 1), withHeights);
    RealWorld.run(cameras + TARGETS, watching, 1).run(5);
    Observed observed = new Observed(watching.observations.get(1), withHeights);
    assertEquals(0.4, observed.number("height"), 1e-6, "4 m of 10");
    assertEquals(0.6, observed.number("goal_tilt"), 1e-6, "54 degrees of 90");
    assertEquals(0, observed.number("tilt"), "while it moves");
    assertEquals(0.6, new Observed(watching.observations.get(4), withHeights).number("tilt"), 1e-6);
    assertEquals(1, observed.number("neighbour0_dx"), "neighbours follow");
    assertEquals(withHeights.size(), LAYOUT.size() + 3);
  }

  @Test
  void offlineCameraObservesOnlyZeros() {
    String off = "<event timestep='1' participant='camera' event='error' name='a' duration='-1'/>";
    WatchingPolicy watching = new WatchingPolicy(RealWorld.always(1, 1));
    RealWorld.run(CAMERAS + TARGETS + events(off), watching, 1).run(3);
    float[] last = watching.observations.get(2);
    float[] first = new float[LAYOUT.size()];
    System.arraycopy(last, 0, first, 0, first.length);
    assertArrayEquals(new float[LAYOUT.size()], first);
    assertEquals(1, last[LAYOUT.size()], "the other is on");
  }

  private static String events(String events) {
    return "<events>" + events + "</events>";
  }

  @Test
  void numbersStayWithinTheirBoundsInRandomRuns() {
    WatchingPolicy watching = new WatchingPolicy(new RandomZoomPolicy());
    String walkers = CAMERAS + TARGETS.replace("speed='0'", "speed='1'");
    RealWorld.run(walkers, watching, 3).run(2_000);
    List<Feature> features = LAYOUT.features();
    int checked = 0;
    for (float[] observation : watching.observations) {
      for (int i = 0; i < observation.length; i++) {
        Feature feature = features.get(i % features.size());
        float number = observation[i];
        assertTrue(number >= feature.low() && number <= feature.high(), feature + ": " + number);
        checked++;
      }
    }
    assertEquals(2_000 * 2 * LAYOUT.size(), checked);
  }

  @Test
  void allocatesNothing() {
    Simulation run = RealWorld.run(CAMERAS + TARGETS, RealWorld.always(1, 1), 1);
    run.step();
    CameraObserver observer = new CameraObserver(run.network(), LAYOUT);
    float[] out = new float[2 * LAYOUT.size()];
    Runnable round =
        () -> {
          for (int i = 0; i < 10_000; i++) {
            observer.observe(run.network(), out);
          }
        };
    round.run();
    assertEquals(0, AllocatedBytes.fewest(() -> AllocatedBytes.by(round)));
  }

  private static Observed observe(ZoomPolicy policy, int steps) {
    WatchingPolicy watching = new WatchingPolicy(policy);
    RealWorld.run(CAMERAS + TARGETS, watching, 1).run(steps + 1);
    return new Observed(watching.observations.get(steps), LAYOUT);
  }

  /** The observation of the first camera. */
  private record Observed(float[] numbers, ObservationLayout layout) {
    double number(String name) {
      List<String> names = layout.features().stream().map(Feature::name).toList();
      return numbers[names.indexOf(name)];
    }
  }

  /** Keeps the observations before each decision of a policy. */
  private static final class WatchingPolicy implements ZoomPolicy {
    private final ZoomPolicy policy;
    private final ObservationLayout layout;
    private final List<float[]> observations = new ArrayList<>();
    private CameraObserver observer;

    WatchingPolicy(ZoomPolicy policy) {
      this(policy, LAYOUT);
    }

    WatchingPolicy(ZoomPolicy policy, ObservationLayout layout) {
      this.policy = policy;
      this.layout = layout;
    }

    @Override
    public String name() {
      return policy.name();
    }

    @Override
    public void begin(NetworkView network, java.util.SplittableRandom random) {
      policy.begin(network, random);
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      observer = observer == null ? new CameraObserver(network, layout) : observer;
      float[] out = new float[network.cameras() * layout.size()];
      observer.observe(network, out);
      observations.add(out);
      policy.decide(network, views);
    }
  }
}
