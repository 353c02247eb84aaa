package org.hificamsim.core.scenario;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Type;
import org.hificamsim.core.scenario.file.Attributes;
import org.hificamsim.core.scenario.file.CameraReader;
import org.hificamsim.core.scenario.file.EventReader;
import org.hificamsim.core.scenario.file.EventSequence;
import org.hificamsim.core.scenario.file.Faults;
import org.hificamsim.core.scenario.file.ObstacleCheck;
import org.hificamsim.core.scenario.file.OpticsReader;
import org.hificamsim.core.scenario.file.TargetReader;
import org.hificamsim.core.scenario.file.TracksReader;
import org.hificamsim.core.scenario.file.VisionGraphReader;
import org.hificamsim.core.scenario.file.ZoneReader;
import org.hificamsim.core.scenario.spec.AgentCheck;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.EventHead;
import org.hificamsim.core.scenario.spec.ObstacleElements;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.core.scenario.xml.XmlElement;
import org.hificamsim.core.scenario.xml.XmlParser;

/**
 * Reads scenario files: CamSim's XML, the coverage study's dialect, and this project's optional
 * attributes ({@code docs/scenario-format.md}).
 *
 * <p>Elements are found by name at any depth, as CamSim does. Malformed, invalid or contradictory
 * input causes an {@link InputException} with its place; unusual or unknown input causes a warning.
 */
public final class ScenarioReader {
  private static final String NO_CAMERA = "no <camera>, expected at least one";
  private static final String NO_TARGET =
      "no <object>, no <tracks> and no event that adds one, expected at least one target";

  private static final Predicate<String> MODEL_FILE =
      Pattern.compile(".+\\.json(@.*)?").asMatchPredicate();

  private final Path path;
  private final XmlElement root;
  private final Predicate<String> movements;
  private final AgentCheck agents;
  private final Faults faults;

  private ScenarioReader(
      Path path,
      Predicate<String> movements,
      AgentCheck agents,
      Consumer<String> warnings,
      Faults faults) {
    this.path = path;
    this.root = XmlParser.parse(path, warnings);
    this.movements = movements;
    this.agents = agents;
    this.faults = faults;
  }

  /**
   * Reads one file.
   *
   * @param movements whether a movement of this short name exists
   * @param warnings receives one line for each warning, with its place
   * @throws InputException if the file is missing or invalid
   */
  public static Scenario read(Path path, Predicate<String> movements, Consumer<String> warnings) {
    return read(path, movements, AgentCheck.NONE, warnings);
  }

  /**
   * Reads one file, and checks the attributes of CamSim's network.
   *
   * @param movements whether a movement of this short name exists
   * @param warnings receives one line for each warning, with its place
   * @throws InputException if the file is missing or invalid
   */
  public static Scenario read(
      Path path, Predicate<String> movements, AgentCheck agents, Consumer<String> warnings) {
    ScenarioReader reader = new ScenarioReader(path, movements, agents, warnings, Faults.thrown());
    return reader.requireRunnable(reader.scenario());
  }

  /**
   * Reads one file that may have no cameras and no targets yet.
   *
   * @param movements whether a movement of this short name exists
   * @param warnings receives one line for each warning, with its place
   * @throws InputException if the file is missing or invalid
   */
  public static Scenario readSite(
      Path path, Predicate<String> movements, Consumer<String> warnings) {
    return new ScenarioReader(path, movements, AgentCheck.NONE, warnings, Faults.thrown())
        .scenario();
  }

  /**
   * Reads one file and reports all faults that do not follow from others. Reading goes on after an
   * invalid camera, object, event or attribute of the simulation, but not after broken XML or
   * without a field. A file without cameras or targets is a site that a run cannot use yet, which
   * is a warning.
   *
   * @param faults receives each fault
   * @return the scenario; empty if there was a fault
   */
  public static Optional<Scenario> check(
      Path path,
      Predicate<String> movements,
      AgentCheck agents,
      Consumer<String> warnings,
      Consumer<InputException> faults) {
    Faults reported = Faults.reported(faults);
    return reported
        .or(
            Optional.<Scenario>empty(),
            () -> {
              ScenarioReader reader =
                  new ScenarioReader(path, movements, agents, warnings, reported);
              Scenario scenario = reader.scenario();
              if (reported.none()) {
                reader.warnOfSite(scenario, warnings);
              }
              return Optional.of(scenario);
            })
        .filter(scenario -> reported.none());
  }

  private Scenario scenario() {
    if (!root.name().equals(ScenarioElements.ROOT.name())) {
      throw root.place().error("the root element is <" + root.name() + ">, expected <root>");
    }
    warnOfUnknown();
    XmlElement simulation = simulation();
    Attributes<Scenario> attributes = new Attributes<>(simulation, Scenario.ELEMENT);
    Scenario.BORDERS.check(attributes, attributes::get);
    Scenario given = Scenario.ELEMENT.make(attributes.spec(faults)).with(Scenario.NAME, name());
    faults.check(() -> checkThreshold(given, attributes));
    Scenario shown = faults.or(given, () -> withFloorplan(given, attributes));
    Scenario scenario = faults.or(shown, () -> withDetection(shown, attributes));
    scenario =
        scenario
            .with(Scenario.OBSTACLES, obstacles())
            .with(
                Scenario.ZONES,
                faults.each(all(Zone.ELEMENT), new ZoneReader(scenario.field())::zone));
    scenario = withParticipants(withZooms(scenario, attributes));
    scenario = scenario.with(Scenario.VISION_GRAPH, VisionGraphReader.read(root));
    if (!scenario.hasHeights()) {
      faults.check(this::refuseDepression);
    }
    attributes.warnOfUnknown();
    return scenario;
  }

  private void refuseDepression() {
    for (XmlElement zone : all(Zone.ELEMENT)) {
      if (zone.attributes().containsKey(Zone.MAX_DEPRESSION)) {
        throw zone.invalid(Zone.MAX_DEPRESSION, Zone.NO_DEPRESSION);
      }
    }
  }

  private void warnOfUnknown() {
    new Attributes<>(root, ScenarioElements.ROOT).warnOfUnknown();
    Map<String, Element<?>> known =
        ScenarioElements.all().stream()
            .collect(Collectors.toMap(Element::name, element -> element));
    root.descendants()
        .filter(xml -> !known.containsKey(xml.name()))
        .forEach(xml -> xml.warn("unknown element <" + xml.name() + ">, ignored"));
    root.descendants()
        .filter(xml -> known.containsKey(xml.name()))
        .filter(xml -> known.get(xml.name()).attributes().isEmpty())
        .forEach(xml -> new Attributes<>(xml, known.get(xml.name())).warnOfUnknown());
  }

  private XmlElement simulation() {
    return root.only(Scenario.ELEMENT.name(), "one")
        .orElseThrow(
            () ->
                root.place()
                    .error("no <simulation>, expected one with min_x, max_x, min_y, max_y"));
  }

  private String name() {
    String file = path.getFileName().toString();
    int dot = file.lastIndexOf('.');
    String base = dot > 0 ? file.substring(0, dot) : file;
    return base.replace(".", "").isEmpty() ? "scenario" : base;
  }

  /** Refuses a threshold in addition to a rule of chance, or to a detection with a rule. */
  private static void checkThreshold(Scenario given, Attributes<Scenario> attributes) {
    if (given.find(Scenario.DETECTION).filter(Scenario::hasOwnRule).isPresent()) {
      String expected = "none together with detection=\"" + given.get(Scenario.DETECTION) + "\"";
      attributes.refuse(Scenario.THRESHOLD, expected);
      attributes.refuse(Scenario.DETECT, expected);
    }
    if (given.threshold().isPresent() && !given.detect().map(DetectionRule::certain).orElse(true)) {
      String rule = given.detect().get().text();
      throw attributes.invalid(Scenario.THRESHOLD, "none together with detect=\"" + rule + "\"");
    }
  }

  /** Resolves the path of a model file from the scenario's folder. */
  private Scenario withDetection(Scenario given, Attributes<Scenario> attributes) {
    try {
      return given.with(
          Scenario.DETECTION,
          given
              .find(Scenario.DETECTION)
              .map(name -> MODEL_FILE.test(name) ? path.resolveSibling(name).toString() : name));
    } catch (InvalidPathException e) {
      throw attributes.invalid(Scenario.DETECTION, "a path from the scenario's folder");
    }
  }

  /**
   * The error about an attribute of {@code <simulation>} whose value proves invalid in use.
   *
   * @param path the file, which has been read before
   */
  public static InputException error(
      Path path, Property<Scenario, ?> attribute, InputException cause) {
    return XmlParser.parse(path, warning -> {})
        .only(Scenario.ELEMENT.name(), "one")
        .map(simulation -> simulation.place(attribute.name()))
        .map(place -> place.error(attribute.name() + ": " + cause.getMessage()))
        .orElse(cause);
  }

  /** Completes the borders of the floorplan by those of the field. */
  private static Scenario withFloorplan(Scenario given, Attributes<Scenario> attributes) {
    if (given.find(Scenario.FLOORPLAN).isEmpty()) {
      Scenario.FLOORPLAN_BORDERS
          .sides()
          .forEach(border -> attributes.refuse(border, "none without floorplan"));
      return given;
    }
    Scenario shown = given;
    for (int side = 0; side < Scenario.BORDERS.sides().size(); side++) {
      Property<Scenario, Double> border = Scenario.FLOORPLAN_BORDERS.sides().get(side);
      Property<Scenario, Double> fieldBorder = Scenario.BORDERS.sides().get(side);
      shown = shown.with(border, given.find(border).orElse(given.get(fieldBorder)));
    }
    Scenario.FLOORPLAN_BORDERS.check(attributes, shown::get);
    return shown;
  }

  private List<Obstacle> obstacles() {
    Map<String, Element<? extends Obstacle>> kinds =
        ObstacleElements.ALL.stream().collect(Collectors.toMap(Element::name, element -> element));
    List<XmlElement> elements =
        root.descendants().filter(xml -> kinds.containsKey(xml.name())).toList();
    return faults.each(elements, xml -> Attributes.read(xml, kinds.get(xml.name())));
  }

  /** Reads the zoom list, which marks the coverage study's dialect. */
  private Scenario withZooms(Scenario scenario, Attributes<Scenario> attributes) {
    if (!hasZooms() && !attributes.has(Scenario.ORDER) && !all(OpticsSpec.ELEMENT).isEmpty()) {
      root.warn(
          "a scenario with <optics> and neither <zoom> nor order runs in CamSim's order, targets"
              + " move and then cameras look; expected order=\"coverage\" or order=\"camsim\"");
    }
    Scenario ordered =
        hasZooms() && !attributes.has(Scenario.ORDER)
            ? scenario.with(Scenario.ORDER, StepOrder.COVERAGE)
            : scenario;
    return ordered.with(Scenario.ZOOMS, faults.or(List.of(), this::zooms));
  }

  private boolean hasZooms() {
    return !all(ScenarioElements.ZOOM_LIST).isEmpty();
  }

  private List<Double> zooms() {
    return root.only(ScenarioElements.ZOOM_LIST.name(), "one for all cameras")
        .map(list -> zooms(list, list.text().strip()))
        .orElse(List.of());
  }

  private static List<Double> zooms(XmlElement list, String text) {
    try {
      return Type.RADII.parser().apply(text);
    } catch (IllegalArgumentException e) {
      throw list.place().invalid("<zoom>", text, Type.RADII.expected());
    }
  }

  /** Reads the cameras, the targets and the events of the scenario. */
  private Scenario withParticipants(Scenario scenario) {
    ObstacleCheck obstacleCheck = new ObstacleCheck(scenario.obstacles());
    Map<String, OpticsSpec> optics = new OpticsReader().all(all(OpticsSpec.ELEMENT), faults);
    CameraReader cameraReader =
        new CameraReader(scenario.field(), scenario.mountHeight(), obstacleCheck, optics, agents);
    TargetReader targetReader =
        new TargetReader(scenario.field(), obstacleCheck, hasZooms(), movements);
    EventReader eventReader = new EventReader(cameraReader, targetReader);
    List<CameraSpec> cameras =
        faults.each(all(CameraSpec.ELEMENT), xml -> cameraReader.camera(xml, CameraSpec.ELEMENT));
    List<TargetSpec> targets =
        new ArrayList<>(faults.each(all(TargetSpec.ELEMENT), targetReader::object));
    targets.addAll(faults.each(all(TargetSpec.WITH_WAYPOINTS), targetReader::withWaypoints));
    List<EventSequence.EventElement> events =
        new ArrayList<>(
            faults.each(
                all(EventHead.ELEMENT),
                xml -> new EventSequence.EventElement(eventReader.event(xml), xml)));
    events.addAll(tracks(scenario));
    if (faults.none()) { // otherwise a missing camera or target may be one with a fault
      new EventSequence(events, cameras, targets, obstacleCheck).check(faults);
    }
    return scenario
        .with(Scenario.CAMERAS, cameras)
        .with(Scenario.TARGETS, targets)
        .with(Scenario.EVENTS, events.stream().map(EventSequence.EventElement::event).toList());
  }

  private List<EventSequence.EventElement> tracks(Scenario scenario) {
    List<XmlElement> elements = all(TracksReader.ELEMENT);
    List<List<ScenarioEvent>> events =
        faults.each(
            elements, xml -> TracksReader.events(xml, path, scenario.stepTime(), scenario.field()));
    faults.check(() -> root.only(TracksReader.ELEMENT.name(), "one"));
    return events.stream()
        .flatMap(List::stream)
        .map(event -> new EventSequence.EventElement(event, elements.get(0)))
        .toList();
  }

  private List<XmlElement> all(Element<?> element) {
    return root.all(element.name());
  }

  /** Refuses a scenario that a run cannot use: one without cameras or targets. */
  private Scenario requireRunnable(Scenario scenario) {
    if (lacksCameras(scenario)) {
      throw simulation().place().error(NO_CAMERA);
    }
    if (lacksTargets(scenario)) {
      throw simulation().place().error(NO_TARGET);
    }
    return scenario;
  }

  private void warnOfSite(Scenario scenario, Consumer<String> warnings) {
    if (lacksCameras(scenario)) {
      warnings.accept(
          simulation().place().line(NO_CAMERA + " for a run; place and view need none"));
    }
    if (lacksTargets(scenario)) {
      warnings.accept(
          simulation().place().line(NO_TARGET + " for a run; place and view need none"));
    }
  }

  private static boolean lacksCameras(Scenario scenario) {
    return scenario.everyCamera().findAny().isEmpty();
  }

  private static boolean lacksTargets(Scenario scenario) {
    return scenario.everyTarget().findAny().isEmpty();
  }
}
