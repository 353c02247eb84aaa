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
 * Generates cameras and targets at random positions of a field, with the zoom levels of the thesis
 * and, by default, the density of its cluster scenarios: 14 cameras on 30 m by 20 m.
 *
 * @param cameras the number of cameras, 1 or more
 * @param targets the number of targets, 1 or more, which go straight at 1 m a step and are 0.66 m
 *     in size
 * @param area the area for each camera, in square metres, above 0
 * @param seed the seed of the positions and headings
 */
public record RandomField(int cameras, int targets, double area, long seed) {
  /** The area for each camera in the cluster scenarios, in square metres. */
  public static final double CLUSTER_AREA = 30.0 * 20.0 / 14;

  /** The number of targets for each camera, about as in the published scenarios. */
  public static final double TARGETS_PER_CAMERA = 0.6;

  private static final List<Double> ZOOMS = List.of(2.5, 3.75, 5.0, 6.25, 7.5);
  private static final double WIDTH_TO_HEIGHT = 1.5;

  /** Returns a field at the cluster scenarios' density with 0.6 targets for each camera. */
  public static RandomField ofCameras(int cameras, long seed) {
    int targets = (int) Math.max(1, Math.round(TARGETS_PER_CAMERA * cameras));
    return new RandomField(cameras, targets, CLUSTER_AREA, seed);
  }

  Field field() {
    double height = Math.sqrt(cameras * area / WIDTH_TO_HEIGHT);
    return new Field(0, WIDTH_TO_HEIGHT * height, 0, height);
  }

  /** Generates the scenario, which is the same for the same arguments. */
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
    List<CameraSpec> specs = new ArrayList<>();
    for (int camera = 1; camera <= cameras; camera++) {
      double x = random.nextDouble(field.maxX());
      double y = random.nextDouble(field.maxY());
      specs.add(new CameraSpec("C" + camera, x, y, widest));
    }
    return specs;
  }

  private List<TargetSpec> targets(Field field, SplittableRandom random) {
    List<TargetSpec> specs = new ArrayList<>();
    for (int target = 1; target <= targets; target++) {
      double x = random.nextDouble(field.maxX());
      double y = random.nextDouble(field.maxY());
      double heading = random.nextDouble(360);
      specs.add(
          new TargetSpec(target, x, y).with(TargetSpec.HEADING, heading).with(TargetSpec.SPEED, 1));
    }
    return specs;
  }
}
