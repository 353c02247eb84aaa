package org.hificamsim.core.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.Seen;
import org.hificamsim.core.energy.EnergyModel;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Range;
import org.hificamsim.core.scenario.declaration.Spec;
import org.hificamsim.core.scenario.declaration.Type;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.hificamsim.core.scenario.spec.Following;
import org.hificamsim.core.scenario.spec.Foreshortening;
import org.hificamsim.core.scenario.spec.Headings;
import org.hificamsim.core.scenario.spec.Occlusion;
import org.hificamsim.core.scenario.spec.ProcessingBudget;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.VisionGraph;
import org.hificamsim.core.scenario.spec.Zone;

/** A scenario: the field with its obstacles, cameras, targets and events. */
public final class Scenario extends Spec<Scenario> {
  /** The number of steps of the longest run. */
  public static final int MAX_STEPS = 1_000_000_000;

  /** The threshold or rule that may follow the name of a detection model. */
  private static final Pattern OWN_RULE = Pattern.compile("@[^@/]*$");

  static final Element<Scenario> ELEMENT =
      Element.of(
          "simulation",
          Scenario.class,
          Scenario::new,
          """
The field, a rectangle whose border belongs to it, and what is in it.
min_x, max_x, min_y, max_y: borders of the field, m; min below max
order: `coverage`: cameras look, then targets move; `camsim`: targets move, then \
cameras look (ours) | `coverage` where there is a zoom list, else `camsim`
headings: of targets: `degrees`, or `as-radians`: sine and cosine take the number as it \
is, as the coverage study's simulator did (ours)
threshold: least confidence that counts as a detection, 0 to 1 (ours) \
| the detection model's
detect: [how a confidence becomes a detection](detection.md), as `chance:alpha=0.01`; no \
`threshold` in addition to one of chance (ours) | `threshold`
detection: the [detection model](detection.md) that the scenario is made for, a name or a \
[model file](profiling.md#the-model-file) with a path from the scenario's folder, as \
`NAME`, `NAME@0.5`, `FILE.json@chance`; no `threshold` or `detect` in addition to `@` (ours) \
| `hifi:orb-lin`
objective: [what a step is scored by](objectives.md): `kmin`, `covered:k=1`, \
`lexicographic` or `sum:cap=3` (ours) | `kmin`
steps: how many steps a run has (ours) | 1000
mount_height: height of the cameras, m, above 0; it gives each zoom radius its \
[focal length](#the-lens) (ours) | the height at which the narrowest radius has 85 mm
step: how long a step takes, s, above 0; it says how far a camera moves in one. Speeds \
of targets are in metres a step whatever it is (ours)
occlusion: `targets`: a target hides those behind it, as a disc of its width. `none`: \
obstacles alone hide (ours)
seen: what of a target has to be [seen](world.md#heights): `feet`, `head`, `face` or `whole` (ours) \
| the detection model's: `head` to recognise, else `whole`
foreshortening: `cosine`: what is seen from above [looks shorter](world.md#heights) (ours)
channel: [what becomes of messages between cameras](channel.md), as \
`loss=0.2,delay=2` (ours) | `perfect`
energy: [what cameras take, and their batteries](energy.md), as \
`cc2420,idle=300mW,battery=5kJ` (ours) | `none`
processing: [how many detections a camera processes in a step](following.md#a-processing-budget); \
the others come a step late (ours) | `none`: all
following: `targets`: [how cameras follow each target](following.md) is measured (ours)
floorplan: a PNG or JPEG that pictures and pages draw under the field; a path from the \
scenario's folder (ours)
floorplan_min_x, floorplan_max_x, floorplan_min_y, floorplan_max_y: what the floorplan \
shows, m (ours) | the field's borders
""");

  static final Borders BORDERS = Borders.of(name -> ELEMENT.required(name, Type.COORDINATE));

  public static final Property<Scenario, StepOrder> ORDER =
      ELEMENT.attribute("order", Type.choice(StepOrder.class), StepOrder.CAMSIM);
  public static final Property<Scenario, Headings> HEADINGS =
      ELEMENT.attribute("headings", Type.choice(Headings.class), Headings.DEGREES);
  public static final Property<Scenario, Double> THRESHOLD =
      ELEMENT.optional("threshold", Type.PROPORTION);
  public static final Property<Scenario, DetectionRule> DETECT =
      ELEMENT.optional("detect", Type.named("", DetectionRule::parse, DetectionRule::text));
  public static final Property<Scenario, String> DETECTION =
      ELEMENT.optional("detection", Type.TEXT);
  public static final Property<Scenario, Objective> OBJECTIVE =
      ELEMENT.optional("objective", Type.named("", Objective::parse, Objective::text));
  public static final Property<Scenario, Integer> STEPS =
      ELEMENT.optional("steps", Type.whole(1, MAX_STEPS));
  public static final Property<Scenario, Double> MOUNT_HEIGHT =
      ELEMENT.optional("mount_height", Type.POSITIVE_LENGTH);
  public static final Property<Scenario, Double> STEP_TIME =
      ELEMENT.optional("step", Type.number(Range.POSITIVE_TIME), 1.0);
  public static final Property<Scenario, Occlusion> OCCLUSION =
      ELEMENT.optional("occlusion", Type.choice(Occlusion.class), Occlusion.NONE);
  public static final Property<Scenario, Seen> SEEN =
      ELEMENT.optional("seen", Type.choice(Seen.class));
  public static final Property<Scenario, Foreshortening> FORESHORTENING =
      ELEMENT.optional("foreshortening", Type.choice(Foreshortening.class), Foreshortening.NONE);
  public static final Property<Scenario, ChannelModel> CHANNEL =
      ELEMENT.optional(
          "channel", Type.named("", ChannelModel::parse, ChannelModel::text), ChannelModel.PERFECT);
  public static final Property<Scenario, EnergyModel> ENERGY =
      ELEMENT.optional(
          "energy", Type.named("", EnergyModel::parse, EnergyModel::text), EnergyModel.NONE);
  public static final Property<Scenario, ProcessingBudget> PROCESSING =
      ELEMENT.optional(
          "processing",
          Type.named("", ProcessingBudget::parse, ProcessingBudget::text),
          ProcessingBudget.UNLIMITED);
  public static final Property<Scenario, Following> FOLLOWING =
      ELEMENT.optional("following", Type.choice(Following.class), Following.NONE);
  static final Property<Scenario, String> FLOORPLAN = ELEMENT.optional("floorplan", Type.TEXT);

  static final Borders FLOORPLAN_BORDERS =
      Borders.of(name -> ELEMENT.optional("floorplan_" + name, Type.COORDINATE));

  /** The file's name without its ending. */
  public static final Property<Scenario, String> NAME = ELEMENT.property("scenario");

  /**
   * The radii that all cameras can choose from, in metres, rising; empty for a plain CamSim
   * scenario, in which each camera has its own range.
   */
  public static final Property<Scenario, List<Double>> ZOOMS = ELEMENT.property(List.of());

  /** The cameras of the start, in file order, with unique names. */
  public static final Property<Scenario, List<CameraSpec>> CAMERAS = ELEMENT.property(List.of());

  /** The targets of the start: objects, then objects with waypoints, in file order. */
  public static final Property<Scenario, List<TargetSpec>> TARGETS = ELEMENT.property(List.of());

  /** The events, in file order. */
  public static final Property<Scenario, List<ScenarioEvent>> EVENTS = ELEMENT.property(List.of());

  /** The links between cameras at the start. */
  public static final Property<Scenario, VisionGraph> VISION_GRAPH = ELEMENT.property(null);

  /** The obstacles, in file order. */
  public static final Property<Scenario, List<Obstacle>> OBSTACLES = ELEMENT.property(List.of());

  /** The obstacles that cameras believe in, if they differ from the real ones; not in files. */
  public static final Property<Scenario, List<Obstacle>> MAP = ELEMENT.property(null);

  /** The zones, in file order, with unique names. */
  public static final Property<Scenario, List<Zone>> ZONES = ELEMENT.property(List.of());

  static {
    ELEMENT.holds("obstacles? & zones? & zoom? & cameras & objects? & events? & visiongraph?");
  }

  private Scenario(Spec<Scenario> spec) {
    super(spec);
  }

  /** Creates a scenario with an empty field. */
  public Scenario(String name, Field field) {
    super(BORDERS.put(ELEMENT.empty().put(NAME, name), field));
  }

  public String name() {
    return get(NAME);
  }

  public Field field() {
    return BORDERS.area(this::get);
  }

  /** The same scenario with other borders. */
  public Scenario withField(Field field) {
    return new Scenario(BORDERS.put(this, field));
  }

  public StepOrder order() {
    return get(ORDER);
  }

  public Headings headings() {
    return get(HEADINGS);
  }

  /** The detection threshold, if the file sets one. */
  public OptionalDouble threshold() {
    return number(THRESHOLD);
  }

  /** The rule of detection, if the file sets one. */
  public Optional<DetectionRule> detect() {
    return find(DETECT);
  }

  public Objective objective() {
    return find(OBJECTIVE).orElseGet(Objective::kMin);
  }

  /** The height of the cameras, in metres, if given. */
  public OptionalDouble mountHeight() {
    return number(MOUNT_HEIGHT);
  }

  /** The duration of a step, in seconds. */
  public double stepTime() {
    return get(STEP_TIME);
  }

  public Occlusion occlusion() {
    return get(OCCLUSION);
  }

  public ChannelModel channel() {
    return get(CHANNEL);
  }

  public EnergyModel energy() {
    return get(ENERGY);
  }

  public ProcessingBudget processing() {
    return get(PROCESSING);
  }

  public Following following() {
    return get(FOLLOWING);
  }

  /** The picture that is drawn under the field. */
  public Optional<Floorplan> floorplan() {
    return find(FLOORPLAN).map(file -> new Floorplan(file, FLOORPLAN_BORDERS.area(this::get)));
  }

  /** The same scenario with another picture under the field. */
  public Scenario withFloorplan(Floorplan floorplan) {
    return new Scenario(FLOORPLAN_BORDERS.put(put(FLOORPLAN, floorplan.file()), floorplan.area()));
  }

  /** The same scenario without a picture under the field. */
  public Scenario withoutFloorplan() {
    return FLOORPLAN_BORDERS.without(without(FLOORPLAN));
  }

  public List<Obstacle> obstacles() {
    return get(OBSTACLES);
  }

  public List<Zone> zones() {
    return get(ZONES);
  }

  public List<Double> zooms() {
    return get(ZOOMS);
  }

  public List<CameraSpec> cameras() {
    return get(CAMERAS);
  }

  public List<TargetSpec> targets() {
    return get(TARGETS);
  }

  public List<ScenarioEvent> events() {
    return get(EVENTS);
  }

  public Optional<VisionGraph> visionGraph() {
    return find(VISION_GRAPH);
  }

  /** Whether the file is in the coverage study's dialect, recognised by its zoom list. */
  public boolean inCoverageDialect() {
    return !zooms().isEmpty();
  }

  /** The cameras of the start, and those that events add. */
  public Stream<CameraSpec> everyCamera() {
    return Stream.concat(
        cameras().stream(),
        events(ScenarioEvent.AddCamera.class).map(ScenarioEvent.AddCamera::camera));
  }

  /** The targets of the start, and those that events add. */
  public Stream<TargetSpec> everyTarget() {
    return Stream.concat(
        targets().stream(),
        events(ScenarioEvent.AddTarget.class).map(ScenarioEvent.AddTarget::target));
  }

  /** The events of a kind, in file order. */
  public <E extends ScenarioEvent> Stream<E> events(Class<E> kind) {
    return events().stream().filter(kind::isInstance).map(kind::cast);
  }

  /** The same scenario with every camera changed, including those added later. */
  public Scenario withCameras(UnaryOperator<CameraSpec> change) {
    return with(CAMERAS, cameras().stream().map(change).toList())
        .withEvents(
            event ->
                event instanceof ScenarioEvent.AddCamera add
                    ? new ScenarioEvent.AddCamera(add.step(), change.apply(add.camera()))
                    : event);
  }

  /** The same scenario with every target changed, including those added later. */
  public Scenario withTargets(UnaryOperator<TargetSpec> change) {
    return with(TARGETS, targets().stream().map(change).toList())
        .withEvents(
            event ->
                event instanceof ScenarioEvent.AddTarget add
                    ? new ScenarioEvent.AddTarget(add.step(), change.apply(add.target()))
                    : event);
  }

  private Scenario withEvents(UnaryOperator<ScenarioEvent> change) {
    return with(EVENTS, events().stream().map(change).toList());
  }

  /** Whether the scenario has any heights; otherwise its world is flat. */
  public boolean hasHeights() {
    return find(SEEN).isPresent()
        || get(FORESHORTENING) != Foreshortening.NONE
        || !obstacles().stream().allMatch(Obstacle::full)
        || everyCamera().anyMatch(CameraSpec::hasHeights)
        || everyTarget().anyMatch(target -> target.seen().isPresent());
  }

  /**
   * The same scenario without heights: obstacles on the ground hide everything, others are removed.
   */
  public Scenario flat() {
    return without(SEEN)
        .with(FORESHORTENING, Foreshortening.NONE)
        .with(
            OBSTACLES,
            obstacles().stream()
                .filter(obstacle -> obstacle.base() == 0)
                .map(Obstacle::flat)
                .toList())
        .withCameras(CameraSpec::flat)
        .withTargets(target -> target.without(TargetSpec.SEEN));
  }

  /** The height of a camera, in metres; NaN in a flat world. */
  public double z(CameraSpec camera) {
    return hasHeights() ? camera.z().orElse(mountHeight().orElse(0)) : Double.NaN;
  }

  /** The same scenario with another rule of detection, and without a threshold. */
  public Scenario withDetect(DetectionRule rule) {
    Scenario ruled = withoutOwnRule().with(DETECT, rule);
    return rule.certain() ? ruled : ruled.without(THRESHOLD);
  }

  /** Whether a detection has a threshold or rule of its own: {@code NAME@0.5}. */
  public static boolean hasOwnRule(String detection) {
    return OWN_RULE.matcher(detection).find();
  }

  /** The same scenario with its detection, but without the rule of that detection. */
  public Scenario withoutOwnRule() {
    return with(DETECTION, find(DETECTION).map(name -> OWN_RULE.matcher(name).replaceFirst("")));
  }

  /** The same scenario with one movement for every target, present or added later. */
  public Scenario withMovement(String movement) {
    return withTargets(target -> target.withMovement(movement));
  }

  /**
   * The attributes and elements of CamSim's network that the scenario uses; not every command
   * simulates the network.
   */
  public List<String> networkParts() {
    List<String> parts =
        new ArrayList<>(
            CameraSpec.OF_NETWORK.stream()
                .filter(property -> everyCamera().anyMatch(camera -> property.text(camera) != null))
                .map(Property::name)
                .toList());
    visionGraph().ifPresent(graph -> parts.add(VisionGraph.ELEMENT.name()));
    if (events(ScenarioEvent.FailRegistration.class).findAny().isPresent()) {
      parts.add("grc events");
    }
    return parts;
  }
}
