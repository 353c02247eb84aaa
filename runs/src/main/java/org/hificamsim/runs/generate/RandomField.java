package org.hificamsim.runs.generate;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.scenario.spec.TargetSpec;

/**
 * Cameras and targets at random places of a field, with the zoom levels of the thesis and, unless
 * said otherwise, the density of its cluster scenarios: 14 cameras on 30 m by 20 m.
 *
 * @param cameras 1 or more
 * @param targets 1 or more; they go straight at 1 m a step and are 0.66 m in size
 * @param area square metres for each camera, above 0
 * @param seed of the places and headings
 */
public record RandomField(int cameras, int targets, double area, long seed) {
  /** Square metres for each camera in the cluster scenarios. */
  public static final double CLUSTER_AREA = 30.0 * 20.0 / 14;

  /** Targets for each camera, about as in the published scenarios. */
  public static final double TARGETS_PER_CAMERA = 0.6;

  private static final List<Double> ZOOMS = List.of(2.5, 3.75, 5.0, 6.25, 7.5);
  private static final double RATIO = 1.5;

  /** A field at the cluster scenarios' density with 0.6 targets for each camera. */
  public static RandomField ofCameras(int cameras, long seed) {
    int targets = (int) Math.max(1, Math.round(TARGETS_PER_CAMERA * cameras));
    return new RandomField(cameras, targets, CLUSTER_AREA, seed);
  }

  /** Half as wide again as it is high. */
  Field field() {
    double height = Math.sqrt(cameras * area / RATIO);
    return new Field(0, RATIO * height, 0, height);
  }

  /** The scenario, the same for the same arguments. */
  public Scenario scenario() {
    Field field = field();
    SplittableRandom random = new SplittableRandom(seed);
    return new Scenario("random-" + cameras, field)
        .with(Scenario.ORDER, StepOrder.COVERAGE)
        .with(Scenario.ZOOMS, ZOOMS)
        .with(Scenario.CAMERAS, cameras(field, random))
        .with(Scenario.TARGETS, targets(field, random));
  }

  private List<CameraSpec> cameras(Field field, SplittableRandom random) {
    double widest = ZOOMS.get(ZOOMS.size() - 1);
    List<CameraSpec> all = new ArrayList<>();
    for (int camera = 1; camera <= cameras; camera++) {
      double x = random.nextDouble(field.maxX());
      double y = random.nextDouble(field.maxY());
      all.add(new CameraSpec("C" + camera, x, y, widest));
    }
    return all;
  }

  private List<TargetSpec> targets(Field field, SplittableRandom random) {
    List<TargetSpec> all = new ArrayList<>();
    for (int target = 1; target <= targets; target++) {
      double x = random.nextDouble(field.maxX());
      double y = random.nextDouble(field.maxY());
      double heading = random.nextDouble(360);
      all.add(
          new TargetSpec(target, x, y).with(TargetSpec.HEADING, heading).with(TargetSpec.SPEED, 1));
    }
    return all;
  }
}
