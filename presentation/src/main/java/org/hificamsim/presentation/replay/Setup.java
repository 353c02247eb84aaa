package org.hificamsim.presentation.replay;

import com.fasterxml.jackson.annotation.JsonIgnore;
import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.annotation.JsonSetter;
import com.fasterxml.jackson.annotation.Nulls;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Following;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.cells.UsualTarget;

/**
 * The scenario and the settings of a run, which do not change while it is shown.
 *
 * @param scenario the name of the scenario
 * @param order the order of a step, which says when targets move: {@code coverage} or {@code
 *     camsim}
 * @param detection the name of the detection
 * @param policy the name of the policy with its options
 * @param seed the seed of the run, or of the first repeat
 * @param targetSize the most frequent size of a target, in metres, for which distances of detection
 *     are shown
 * @param onAxis whether detection depends on the bearing; the distances are along the heading then
 * @param cameras the cameras in the order of their numbers, including those that events add
 * @param targets the targets in the order of their numbers, including those that events add
 * @param widths the width of each target by number, in metres; empty if all widths equal the sizes
 * @param slow the numbers of cameras that need time to turn
 * @param obstacles the obstacles in the order of the scenario
 * @param floor pictures under the field, at most one
 * @param zones each with the detection and number of cameras that it demands
 * @param following whether frames say which camera has each target
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
    List<Camera> cameras,
    List<Target> targets,
    @IfAny List<Double> widths,
    @IfAny List<Integer> slow,
    @IfAny List<Obstacle> obstacles,
    @IfAny List<Floor> floor,
    @IfAny List<DemandingZone> zones,
    @JsonInclude(JsonInclude.Include.NON_DEFAULT) @JsonSetter(nulls = Nulls.AS_EMPTY)
        boolean following) {
  /**
   * The part of a {@link Zone} with a demand that pages show.
   *
   * @param faces whether it matters from where cameras look, which a heat map does not know
   */
  public record DemandingZone(
      String name,
      Zone.Shape shape,
      List<Point> points,
      String detection,
      int k,
      double weight,
      @JsonInclude(JsonInclude.Include.NON_DEFAULT) @JsonSetter(nulls = Nulls.AS_EMPTY)
          boolean faces) {
    private static DemandingZone of(Zone zone) {
      return new DemandingZone(
          zone.name(),
          zone.shape(),
          zone.points(),
          zone.detection(),
          zone.k(),
          zone.weight(),
          zone.asksForFaces());
    }
  }

  /** A camera at the start, or where an event will add it. */
  public record Camera(String name, CameraPose pose) {}

  /**
   * A target.
   *
   * @param size the edge of its bounding box, in metres
   */
  public record Target(String name, double size) {}

  /**
   * A picture that is drawn under the field.
   *
   * @param area the area that it shows, in metres
   * @param data the picture as a data URI, PNG or JPEG
   */
  public record Floor(Field area, String data) {}

  private static final Pattern BY_CHANCE = Pattern.compile("@(chance|probability)");

  /**
   * Returns the setup of a world before its first step.
   *
   * @param floor pictures under the field
   */
  public static Setup of(
      World world, Detection detection, String policy, long seed, List<Floor> floor) {
    List<Target> targets =
        IntStream.range(0, world.targets().count())
            .mapToObj(i -> new Target(world.targets().name(i), world.targets().size(i)))
            .toList();
    double size = UsualTarget.size(world, detection.model());
    List<Obstacle> obstacles = world.scenario().obstacles();
    Poses poses = new Poses(detection, size, obstacles, world.scenario().field());
    List<Camera> cameras =
        IntStream.range(0, world.cameras().count()).mapToObj(i -> camera(world, i, poses)).toList();
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
        targets,
        widths(world.targets()),
        slow(world),
        obstacles,
        floor,
        world.scenario().zones().stream()
            .map(zone -> zone.withDefaults(detection.name(), world.scenario().objective()))
            .map(DemandingZone::of)
            .toList(),
        world.scenario().following() == Following.TARGETS);
  }

  private static Camera camera(World world, int camera, Poses poses) {
    return new Camera(
        world.cameras().name(camera), poses.of(world.cameras(), camera, world.cameraSpec(camera)));
  }

  private static List<Double> widths(Targets targets) {
    boolean widthsEqualSizes =
        IntStream.range(0, targets.count()).allMatch(i -> targets.width(i) == targets.size(i));
    return widthsEqualSizes
        ? List.of()
        : IntStream.range(0, targets.count()).mapToObj(targets::width).toList();
  }

  private static List<Integer> slow(World world) {
    return IntStream.range(0, world.cameras().count())
        .filter(i -> world.cameraSpec(i).optics().filter(OpticsSpec::takesTime).isPresent())
        .boxed()
        .toList();
  }

  /** The width of a target, in metres. */
  public double width(int target) {
    return widths.isEmpty() ? targets.get(target).size() : widths.get(target);
  }

  /** Whether targets are detected by chance, according to the detection's name. */
  @JsonIgnore
  public boolean isByChance() {
    return BY_CHANCE.matcher(detection).find();
  }

  /** Returns how many numbers a frame has, without its step. */
  public long numbersPerFrame() {
    return (following ? 5L : 4L) * targets.size()
        + (slow.isEmpty() ? 0 : cameras.size())
        + cameras.stream().mapToLong(camera -> 3 + 2L * camera.pose().views()).sum();
  }
}
