package org.hificamsim.core.scenario;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.metrics.Objective;

/**
 * Reads scenario files: CamSim's XML, the coverage study's dialect, and this project's optional
 * attributes ({@code docs/scenario-format.md}).
 *
 * <p>Elements are found by name at any depth, as CamSim does. Whatever is malformed, out of range
 * or contradictory is an {@link org.hificamsim.core.InputException} with its place; what is merely
 * odd or unknown is a warning.
 */
public final class ScenarioReader {
  private static final Set<String> ELEMENTS =
      Set.of(
          "simulation",
          "cameras",
          "camera",
          "zoom",
          "optics",
          "obstacles",
          "wall",
          "polygon",
          "pillar",
          "objects",
          "object",
          "object_with_waypoints",
          "waypoint",
          "tracks",
          "events",
          "event",
          "visiongraph",
          "graphnode",
          "neighbour");

  private static final Set<String> WITHOUT_ATTRIBUTES =
      Set.of("cameras", "zoom", "obstacles", "objects", "events");

  private static final Range STEP_TIME =
      new Range("a number above 0 and at most 1e9 (s)", value -> value > 0 && value <= 1e9);

  private final Path path;
  private final XmlElement root;
  private final Predicate<String> movements;
  private final AgentCheck agents;
  private final Consumer<String> warnings;
  private final Faults faults;

  private ScenarioReader(
      Path path,
      Predicate<String> movements,
      AgentCheck agents,
      Consumer<String> warnings,
      Faults faults) {
    this.path = path;
    this.root = XmlParser.parse(path);
    this.movements = movements;
    this.agents = agents;
    this.warnings = warnings;
    this.faults = faults;
  }

  /**
   * Reads one file.
   *
   * @param movements whether a movement of this short name exists
   * @param warnings takes one line for each thing that is odd, with its place
   * @throws org.hificamsim.core.InputException when the file is missing or wrong
   */
  public static Scenario read(Path path, Predicate<String> movements, Consumer<String> warnings) {
    return read(path, movements, AgentCheck.NONE, warnings);
  }

  /**
   * Reads one file, and checks what its cameras ask of the network.
   *
   * @param movements whether a movement of this short name exists
   * @param warnings takes one line for each thing that is odd, with its place
   * @throws org.hificamsim.core.InputException when the file is missing or wrong
   */
  public static Scenario read(
      Path path, Predicate<String> movements, AgentCheck agents, Consumer<String> warnings) {
    return new ScenarioReader(path, movements, agents, warnings, Faults.thrown()).scenario();
  }

  /**
   * Reads one file and reports all faults that do not follow from others: reading goes on after a
   * camera, object, event or attribute of the simulation that is wrong, though not after broken XML
   * or without a field.
   *
   * @param faults takes each fault
   * @return the scenario; empty where there was a fault
   */
  public static Optional<Scenario> check(
      Path path,
      Predicate<String> movements,
      AgentCheck agents,
      Consumer<String> warnings,
      Consumer<InputException> faults) {
    Faults reported = Faults.reported(faults);
    Optional<Scenario> scenario =
        reported.of(
            () -> new ScenarioReader(path, movements, agents, warnings, reported).scenario());
    return scenario.filter(one -> reported.none());
  }

  private Scenario scenario() {
    if (!root.name().equals("root")) {
      throw root.place().error("the root element is <" + root.name() + ">, expected <root>");
    }
    warnAboutUnknownElements();
    XmlElement simulation = simulation();
    Attributes attributes = new Attributes(simulation);
    Field field = field(simulation, attributes);
    boolean zooming = !root.all("zoom").isEmpty();
    StepOrder order = zooming ? StepOrder.COVERAGE : StepOrder.CAMSIM;
    order = or(order, standard -> attributes.choice("order", standard));
    Headings headings = or(Headings.DEGREES, standard -> attributes.choice("headings", standard));
    OptionalDouble threshold = number(attributes, "threshold", Range.PROPORTION);
    Optional<DetectionRule> detect =
        or(Optional.empty(), none -> detect(attributes, threshold.isPresent()));
    Objective objective =
        or(
            Objective.kMin(),
            kMin -> attributes.optional("objective", Objective::parse).orElse(kMin));
    OptionalDouble mountHeight = number(attributes, "mount_height", Range.POSITIVE_LENGTH);
    double stepTime = number(attributes, "step", STEP_TIME).orElse(1);
    Surroundings surroundings =
        new SurroundingsReader(root, field, warnings, faults).surroundings(attributes);
    List<Double> zooms = or(List.of(), none -> new ZoomListReader(root).zooms());
    Clearing clearing = new Clearing(surroundings, warnings);
    OpticsReader opticsReader = new OpticsReader(warnings);
    faults.each(root.all("optics"), opticsReader::optics);
    CameraReader cameraReader = new CameraReader(field, clearing, opticsReader, agents, warnings);
    TargetReader targetReader = new TargetReader(field, clearing, zooming, movements, warnings);
    List<CameraSpec> cameras = faults.each(root.all("camera"), cameraReader::camera);
    List<TargetSpec> targets = targets(targetReader);
    List<ScenarioEvent> events =
        new EventReader(cameraReader, targetReader, warnings, faults)
            .events(
                cameras,
                root.all("event"),
                root.all("tracks"),
                new TracksReader(path, field, stepTime, warnings));
    if (faults.none()) {
      requireSome(simulation, cameras, targets, events);
    }
    return new Scenario(
        name(),
        field,
        order,
        headings,
        threshold,
        detect,
        objective,
        mountHeight,
        stepTime,
        surroundings,
        zooms,
        cameras,
        targets,
        events,
        visionGraph(),
        attributes.leftOver(warnings));
  }

  private <T> T or(T standard, UnaryOperator<T> reader) {
    return faults.of(() -> reader.apply(standard)).orElse(standard);
  }

  private OptionalDouble number(Attributes attributes, String name, Range range) {
    return or(OptionalDouble.empty(), none -> attributes.optionalNumber(name, range));
  }

  /** A rule of chance has a threshold of its own. */
  private static Optional<DetectionRule> detect(Attributes attributes, boolean hasThreshold) {
    Optional<DetectionRule> detect = attributes.optional("detect", DetectionRule::parse);
    if (hasThreshold && detect.isPresent() && !detect.get().certain()) {
      throw attributes.invalid("threshold", "none beside detect=\"" + detect.get().text() + "\"");
    }
    return detect;
  }

  private List<TargetSpec> targets(TargetReader reader) {
    return Stream.concat(
            faults.each(root.all("object"), reader::object).stream(),
            faults.each(root.all("object_with_waypoints"), reader::objectWithWaypoints).stream())
        .toList();
  }

  private static void requireSome(
      XmlElement simulation,
      List<CameraSpec> cameras,
      List<TargetSpec> targets,
      List<ScenarioEvent> events) {
    if (cameras.isEmpty() && events.stream().noneMatch(ScenarioEvent.AddCamera.class::isInstance)) {
      throw simulation.place().error("no <camera>, expected at least one");
    }
    if (targets.isEmpty() && events.stream().noneMatch(ScenarioEvent.AddTarget.class::isInstance)) {
      throw simulation
          .place()
          .error(
              "no <object>, no <tracks> and no event that adds one, expected at least one target");
    }
  }

  private String name() {
    String file = path.getFileName().toString();
    int dot = file.lastIndexOf('.');
    String base = dot > 0 ? file.substring(0, dot) : file;
    return base.replace(".", "").isEmpty() ? "scenario" : base;
  }

  private XmlElement simulation() {
    List<XmlElement> all = root.all("simulation");
    if (all.isEmpty()) {
      throw root.place().error("no <simulation>, expected one with min_x, max_x, min_y, max_y");
    }
    if (all.size() > 1) {
      throw all.get(1).place().error("a second <simulation>, expected one");
    }
    return all.get(0);
  }

  private static Field field(XmlElement simulation, Attributes attributes) {
    Field field =
        new Field(
            attributes.number("min_x", Range.COORDINATE),
            attributes.number("max_x", Range.COORDINATE),
            attributes.number("min_y", Range.COORDINATE),
            attributes.number("max_y", Range.COORDINATE));
    if (!(field.width() > 0)) {
      throw new Attributes(simulation).invalid("max_x", "more than min_x, " + field.minX());
    }
    if (!(field.height() > 0)) {
      throw new Attributes(simulation).invalid("max_y", "more than min_y, " + field.minY());
    }
    return field;
  }

  private Optional<VisionGraph> visionGraph() {
    List<XmlElement> graphs = root.all("visiongraph");
    if (graphs.isEmpty() || graphs.get(0).all("graphnode").isEmpty()) {
      return Optional.empty();
    }
    Map<String, List<String>> neighbours = new LinkedHashMap<>();
    Set<String> seen = new HashSet<>();
    for (XmlElement node : root.all("graphnode")) {
      String camera = nameOf(node);
      if (!seen.add(camera)) {
        warnings.accept(
            node.place("name")
                + ": a second <graphnode> for '"
                + XmlText.shortened(camera, Attributes.MAX_QUOTED)
                + "', the last one counts");
        neighbours.remove(camera);
      }
      neighbours.put(camera, node.all("neighbour").stream().map(this::nameOf).toList());
    }
    Attributes attributes = new Attributes(graphs.get(0));
    String isStatic = attributes.optionalText("static").orElse("false");
    attributes.leftOver(warnings);
    return Optional.of(new VisionGraph(Boolean.parseBoolean(isStatic), neighbours));
  }

  private String nameOf(XmlElement element) {
    Attributes attributes = new Attributes(element);
    String name = attributes.text("name", "the name of a camera");
    attributes.leftOver(warnings);
    return name;
  }

  private void warnAboutUnknownElements() {
    new Attributes(root).leftOver(warnings);
    root.below()
        .filter(element -> !ELEMENTS.contains(element.name()))
        .forEach(
            element ->
                warnings.accept(
                    element.place() + ": unknown element <" + element.name() + ">, ignored"));
    root.below()
        .filter(element -> WITHOUT_ATTRIBUTES.contains(element.name()))
        .forEach(element -> new Attributes(element).leftOver(warnings));
  }
}
