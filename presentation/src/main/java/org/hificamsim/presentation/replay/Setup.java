package org.hificamsim.presentation.replay;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;

/**
 * What does not change while a run is watched: the scenario and the settings.
 *
 * @param scenario its name
 * @param order when targets move: {@code coverage} or {@code camsim}
 * @param detection the model's name
 * @param policy name and options
 * @param seed of the run, or of the first repeat
 * @param targetSize the most frequent size of a target, metres: that of the detected ranges
 * @param onAxis whether detection depends on the bearing, so that ranges are those along the
 *     heading
 * @param cameras by number, with those that events add
 * @param targets by number, with those that events add
 */
public record Setup(
    String scenario,
    Field field,
    String order,
    String detection,
    double threshold,
    String policy,
    long seed,
    double targetSize,
    boolean onAxis,
    List<CameraSetup> cameras,
    List<TargetSetup> targets) {
  private static final Pattern BY_CHANCE = Pattern.compile("@(chance|probability)");

  /** The set-up of a world that has not begun yet. */
  public static Setup of(World world, Detection detection, String policy, long seed) {
    List<TargetSetup> targets =
        IntStream.range(0, world.targets().count())
            .mapToObj(i -> new TargetSetup(world.targets().name(i), world.targets().size(i)))
            .toList();
    double size = DetectedRanges.usualSize(world);
    DetectedRanges ranges = new DetectedRanges(detection, size);
    List<CameraSetup> cameras =
        IntStream.range(0, world.cameras().count())
            .mapToObj(i -> new CameraSetup(world.cameras().name(i), pose(world, i, ranges)))
            .toList();
    return new Setup(
        world.scenario().name(),
        world.scenario().field(),
        Spelling.of(world.scenario().order()),
        detection.name(),
        detection.threshold(),
        policy,
        seed,
        size,
        detection.model().dependsOnBearing(),
        cameras,
        targets);
  }

  /** Whether targets are detected by chance, as the detection's name says. */
  public boolean byChance() {
    return BY_CHANCE.matcher(detection).find();
  }

  /** How many numbers a frame holds, but for its step. */
  public long numbersPerFrame() {
    return 4L * targets.size()
        + cameras.stream().mapToLong(camera -> 3 + 2L * camera.pose().levels().size()).sum();
  }

  /** A camera that is yet to be added stands nowhere in the world: the scenario says where. */
  private static CameraPose pose(World world, int camera, DetectedRanges ranges) {
    CameraSpec spec = world.cameraSpec(camera);
    Cameras cameras = world.cameras();
    List<Level> levels = ranges.levels(cameras.views(camera), level -> cameras.zoom(camera, level));
    double angle = cameras.zoom(camera, 0).viewingAngle();
    return new CameraPose(spec.x(), spec.y(), Math.toRadians(spec.heading()), angle, levels);
  }
}
