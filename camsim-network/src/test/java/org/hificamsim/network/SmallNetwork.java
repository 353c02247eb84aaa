package org.hificamsim.network;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.engine.WidestPolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.hificamsim.network.NetworkSettings.GraphUse;
import org.hificamsim.network.agent.HistoricalParameters;
import org.hificamsim.network.bandit.BanditAlgorithm;
import org.hificamsim.network.bandit.BanditParameters;
import org.hificamsim.network.statistics.StepFigures;

/** Builds a network of a few cameras in a field of 100 m by 100 m for a test. */
final class SmallNetwork {
  private final StringBuilder cameras = new StringBuilder();
  private final StringBuilder targets = new StringBuilder();
  private final StringBuilder events = new StringBuilder();
  private final StringBuilder obstacles = new StringBuilder();
  private String attributes = "";
  private ZoomPolicy policy = new WidestPolicy();
  private String graph = "";
  private Set<Quirk> quirks = EnumSet.allOf(Quirk.class);
  private GraphUse graphUse = GraphUse.AS_IN_FILE;
  private Optional<BanditAlgorithm> bandit = Optional.empty();
  private int errorLevel = -1;
  private int resetLevel = 50;
  private NetworkRun run;
  private final List<StepFigures> rows = new ArrayList<>();

  /** Adds a camera that sees in all directions. */
  SmallNetwork camera(String name, double x, double y, double range, String attributes) {
    cameras.append(
        "<camera name='%s' x='%s' y='%s' heading='0' viewing_angle='360' range='%s' %s/>"
            .formatted(name, x, y, range, attributes));
    return this;
  }

  /** Adds an XML element of optics, or of a camera with optics. */
  SmallNetwork cameraElement(String element) {
    cameras.append(element);
    return this;
  }

  /** Adds the XML element of a wall, polygon or pillar. */
  SmallNetwork obstacle(String element) {
    obstacles.append(element);
    return this;
  }

  /** Sets the attributes of the simulation element, apart from its field. */
  SmallNetwork simulation(String newAttributes) {
    attributes = newAttributes;
    return this;
  }

  SmallNetwork policy(ZoomPolicy chosen) {
    policy = chosen;
    return this;
  }

  /** Adds a target that does not move. */
  SmallNetwork still(String features, double x, double y) {
    return target("features='%s' x='%s' y='%s' heading='0' speed='0'".formatted(features, x, y));
  }

  SmallNetwork target(String attributes) {
    targets.append("<object ").append(attributes).append("/>");
    return this;
  }

  SmallNetwork targetElement(String element) {
    targets.append(element);
    return this;
  }

  SmallNetwork event(String attributes) {
    events.append("<event ").append(attributes).append("/>");
    return this;
  }

  SmallNetwork eventElement(String element) {
    events.append(element);
    return this;
  }

  SmallNetwork graph(boolean isStatic, String nodes) {
    graph = "<visiongraph static='%s'>%s</visiongraph>".formatted(isStatic, nodes);
    return this;
  }

  SmallNetwork without(Quirk quirk) {
    quirks = EnumSet.allOf(Quirk.class);
    quirks.remove(quirk);
    return this;
  }

  SmallNetwork bandit(BanditAlgorithm algorithm) {
    bandit = Optional.of(algorithm);
    return this;
  }

  SmallNetwork errorLevel(int level) {
    errorLevel = level;
    return this;
  }

  SmallNetwork resetLevel(int level) {
    resetLevel = level;
    return this;
  }

  /** Runs a number of further steps. */
  SmallNetwork run(int steps) {
    if (run == null) {
      start();
    }
    for (int i = 0; i < steps; i++) {
      run.simulation().step();
    }
    return this;
  }

  StepFigures row(int step) {
    return rows.get(step);
  }

  StepFigures last() {
    return rows.get(rows.size() - 1);
  }

  World world() {
    return run.world();
  }

  /** Returns whether a camera sees a target. */
  boolean sees(int camera, int target) {
    return run.network().sightings().sees(camera, target);
  }

  /** Returns the confidence with which a camera sees a target. */
  double confidence(int camera, int target) {
    return run.network().sightings().confidence(camera, target);
  }

  /** The names of the cameras that own a target, joined. */
  String owners(String features) {
    World world = run.world();
    StringBuilder owners = new StringBuilder();
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      for (int target : run.network().owned(camera)) {
        if (world.targets().name(target).equals(features)) {
          owners.append(world.cameras().name(camera));
        }
      }
    }
    return owners.toString();
  }

  private void start() {
    NetworkSettings settings =
        new NetworkSettings(
            List.of(),
            Optional.empty(),
            Optional.empty(),
            bandit,
            graphUse,
            errorLevel,
            resetLevel,
            BanditParameters.DEFAULT,
            HistoricalParameters.DEFAULT,
            quirks);
    Detection detection = Detection.of(new CamSimVisibilityDetection());
    Scenario scenario = CamSimScenario.withQuirks(scenario(), settings);
    run = new NetworkRun(scenario, detection, policy, Movements.registry(), settings, 0);
    run.listen((view, coverage) -> rows.add(run.network().figures()));
  }

  private Scenario scenario() {
    String text =
        ("<root><simulation min_x='-50' max_x='50' min_y='-50' max_y='50'"
                + " %s><obstacles>%s</obstacles>"
                + "<cameras>%s</cameras><objects>%s</objects><events>%s</events>%s</simulation>"
                + "</root>")
            .formatted(attributes, obstacles, cameras, targets, events, graph);
    try {
      Path file = Files.createTempFile("small", ".xml");
      Files.writeString(file, text);
      Scenario scenario = ScenarioReader.read(file, movement -> true, warning -> {});
      Files.delete(file);
      return scenario;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
