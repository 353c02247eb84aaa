package org.hificamsim.agents.observation;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.agents.baseline.RandomZoomPolicy;
import org.hificamsim.agents.cooperative.CooperativeZoomPolicy;
import org.hificamsim.agents.toy.RealWorld;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.junit.jupiter.api.Test;

class BeliefFeaturesTest {
  private static final int VIEWS = 5;
  private static final ObservationLayout WITHOUT = new ObservationLayout(2, 1, false);
  private static final ObservationLayout LAYOUT = WITHOUT.withViews(VIEWS);
  private static final String OPTICS =
      "<optics name='o' hfov='30 60' reach='12' pan='-90 0' pan_speed='40'/>";
  private static final String TARGETS = targets();

  private static String camera(String name, double x, double y) {
    return "<camera name='%s' x='%s' y='%s' heading='0' viewing_angle='60' range='12' optics='o'/>"
        .formatted(name, x, y);
  }

  private static String targets() {
    StringBuilder elements = new StringBuilder();
    for (int name = 0; name < 12; name++) {
      elements.append(
          "<object features='%s' x='%s' y='%s' heading='%s' speed='0.4' size='0.5'/>"
              .formatted(name, -12 + name, 7 - name % 4, 40 * name));
    }
    return elements.toString();
  }

  private static String cameras() {
    return OPTICS + camera("a", -6, 0) + camera("b", 3, 1);
  }

  @Test
  void beliefStaysWithinBoundsAndChangesNoOtherNumbers() {
    ObservedPolicy observed = new ObservedPolicy(new RandomZoomPolicy());
    RealWorld.run(cameras() + TARGETS, observed, 3).run(300);
    List<Feature> features = LAYOUT.features();
    assertEquals(LAYOUT.size(), features.size());
    for (int step = 0; step < 300; step++) {
      float[] numbers = observed.observations.get(step);
      for (int i = 0; i < numbers.length; i++) {
        Feature feature = features.get(i % features.size());
        assertTrue(numbers[i] >= feature.low() && numbers[i] <= feature.high(), feature.name());
      }
      for (int camera = 0; camera < 2; camera++) {
        assertArrayEquals(
            Arrays.copyOfRange(
                observed.plain.get(step), camera * WITHOUT.size(), (camera + 1) * WITHOUT.size()),
            Arrays.copyOfRange(
                numbers, camera * LAYOUT.size(), camera * LAYOUT.size() + WITHOUT.size()));
      }
    }
  }

  @Test
  void describesEachViewAndPadsTheRest() {
    ObservedPolicy observed = new ObservedPolicy(new RandomZoomPolicy());
    RealWorld.run(cameras() + TARGETS, observed, 3).run(50);
    for (int step = 1; step < 50; step++) {
      for (int camera = 0; camera < 2; camera++) {
        double chosen = 0;
        double greatest = 0;
        for (int view = 0; view < 4; view++) {
          assertEquals(1, observed.number(step, camera, view, "exists"));
          chosen += observed.number(step, camera, view, "chosen");
          greatest = Math.max(greatest, observed.number(step, camera, view, "gain_share"));
          assertTrue(
              observed.number(step, camera, view, "known")
                  <= observed.number(step, camera, view, "targets") + 1e-6);
        }
        assertEquals(1, chosen);
        assertEquals(1, greatest);
        for (Feature feature : BeliefFeatures.VIEW) {
          assertEquals(0, observed.number(step, camera, 4, feature.name()));
        }
      }
    }
  }

  /**
   * A lone camera has nobody to agree with: if moves have no price, the greatest gain is what
   * {@code cooperative} takes.
   */
  @Test
  void greatestGainOfLoneCameraIsChoiceOfCooperative() {
    ZoomPolicy cooperative = new CooperativeZoomPolicy(Options.parse("cooperative", "hold=0"));
    ObservedPolicy observed = new ObservedPolicy(cooperative);
    RealWorld.run(OPTICS + camera("a", -6, 0) + TARGETS, observed, 3).run(300);
    int changes = 0;
    for (int step = 0; step < 300; step++) {
      int present = observed.present.get(step)[0];
      int best = present;
      for (int view = 0; view < 4; view++) {
        best = observed.gain(step, view) > observed.gain(step, best) ? view : best;
      }
      assertEquals(best, observed.chosen.get(step)[0], "step " + step);
      changes += best == present ? 0 : 1;
    }
    assertTrue(changes > 10, changes + " changes");
  }

  @Test
  void targetCoveredByAnotherCameraIsWorthLess() {
    String twins = OPTICS + camera("a", 0, 0) + camera("b", 0, 0);
    String target = "<object features='1' x='0' y='5' heading='0' speed='0' size='1'/>";
    ObservedPolicy alone = new ObservedPolicy(RealWorld.always(2));
    RealWorld.run(OPTICS + camera("a", 0, 0) + target, alone, 1).run(20);
    ObservedPolicy both = new ObservedPolicy(RealWorld.always(2, 2));
    RealWorld.run(twins + target, both, 1).run(20);
    assertEquals(alone.number(19, 0, 2, "targets"), both.number(19, 0, 2, "targets"), 1e-6);
    assertEquals(0, alone.number(19, 0, 2, "covered"));
    assertEquals(1, both.number(19, 0, 2, "covered"), 1e-6);
    assertTrue(both.number(19, 0, 2, "known") < alone.number(19, 0, 2, "known"));
  }

  /** Records what a policy's cameras observe, and what they choose. */
  private static final class ObservedPolicy implements ZoomPolicy {
    private final ZoomPolicy policy;
    private final List<float[]> observations = new ArrayList<>();
    private final List<float[]> plain = new ArrayList<>();
    private final List<int[]> present = new ArrayList<>();
    private final List<int[]> chosen = new ArrayList<>();
    private CameraObserver observer;
    private CameraObserver plainObserver;

    ObservedPolicy(ZoomPolicy policy) {
      this.policy = policy;
    }

    double number(int step, int camera, int view, String name) {
      List<String> names = BeliefFeatures.VIEW.stream().map(Feature::name).toList();
      int at = camera * LAYOUT.size() + LAYOUT.firstView() + view * names.size();
      return observations.get(step)[at + names.indexOf(name)];
    }

    /** The gain of a view of the first camera, in targets. */
    double gain(int step, int view) {
      double share = number(step, 0, view, "gain");
      return share / (1 - share);
    }

    @Override
    public String name() {
      return policy.name();
    }

    @Override
    public void begin(NetworkView network, java.util.SplittableRandom random) {
      policy.begin(network, random);
      observer = null;
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      if (observer == null) {
        observer = new CameraObserver(network, LAYOUT);
        plainObserver = new CameraObserver(network, WITHOUT);
      }
      float[] out = new float[network.cameras() * LAYOUT.size()];
      observer.observe(network, out);
      observations.add(out);
      float[] plainOut = new float[network.cameras() * WITHOUT.size()];
      plainObserver.observe(network, plainOut);
      plain.add(plainOut);
      present.add(presentViews(network, views.length));
      policy.decide(network, views);
      chosen.add(views.clone());
      observer.learnChoices(network, views);
    }

    private static int[] presentViews(NetworkView network, int cameras) {
      int[] views = new int[cameras];
      Arrays.setAll(views, network::view);
      return views;
    }
  }
}
