package org.hificamsim.network.rules;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.hificamsim.core.CamSimCommand;
import org.hificamsim.network.rules.RuleObject.Border;
import org.hificamsim.network.statistics.StepFigures;
import org.w3c.dom.Element;

/**
 * A run of cameras that choose their ranges by a bandit and broadcast, as docs/camsim-behaviour.md
 * describes it, section 7 above all. It shares no code with the network that it checks.
 */
public final class RuleRun {
  private final List<RuleCamera> cameras = new ArrayList<>();
  private final List<RuleObject> objects = new ArrayList<>();
  private final List<Element> events;
  private final RuleCamera.Counts counts = new RuleCamera.Counts();
  private final Border border;
  private final String bandit;
  private final int errorLevel;
  private final int resetLevel;
  private final Random banditStream;
  private final Random moveStream;
  private final Random turnStream;
  private final Random errorStream;

  public RuleRun(String scenario, CamSimCommand command) {
    Element root = RuleXml.parse(scenario);
    Element field = RuleXml.children(root, "simulation").get(0);
    border =
        new Border(
            RuleXml.number(field, "min_x"),
            RuleXml.number(field, "max_x"),
            RuleXml.number(field, "min_y"),
            RuleXml.number(field, "max_y"));
    bandit = command.option("-b").orElseThrow();
    errorLevel = command.number("-e").orElse(-1);
    resetLevel = command.number("-r").orElse(50);
    banditStream = new Random(command.seed());
    moveStream = new Random(command.seed());
    turnStream = new Random(command.seed());
    errorStream = new Random(command.seed());
    RuleXml.children(root, "camera").forEach(this::addCamera);
    RuleXml.children(root, "object").forEach(object -> addObject(RuleObject.inFile(object)));
    RuleXml.children(root, "object_with_waypoints")
        .forEach(object -> addObject(RuleObject.inFile(object)));
    events = RuleXml.children(root, "event");
  }

  private void addCamera(Element element) {
    double[] topLeft = {border.minX(), border.minY()};
    RuleBandit learner = new RuleBandit(bandit, banditStream);
    RuleCamera added = new RuleCamera(element, learner, counts, topLeft);
    for (RuleCamera camera : cameras) {
      added.neighbours.add(camera);
      if (camera.online) {
        camera.neighbours.add(added);
      }
    }
    cameras.add(added);
  }

  private void addObject(RuleObject object) {
    objects.add(object);
    for (RuleCamera camera : cameras) {
      if (camera.online) {
        camera.search.put(object, RuleCamera.NOBODY);
      }
    }
  }

  /** Runs one step and returns its row (10.1). */
  public StepFigures step(int step) {
    counts.communication = 0;
    counts.handovers = 0;
    events.stream().filter(event -> RuleXml.number(event, "timestep") == step).forEach(this::fire);
    objects.forEach(object -> object.move(moveStream, turnStream, border));
    drawError();
    List<RuleCamera> online = cameras.stream().filter(camera -> camera.online).toList();
    online.forEach(camera -> camera.look(objects));
    online.forEach(RuleCamera::advertise);
    online.forEach(RuleCamera::lookForSearched);
    return settle(step, online);
  }

  private StepFigures settle(int step, List<RuleCamera> online) {
    long attempts = 0;
    double overlap = 0.0;
    double confidence = 0.0;
    int tracked = 0;
    for (int i = 0; i < online.size(); i++) {
      RuleCamera camera = online.get(i);
      attempts += camera.sent;
      camera.update();
      for (RuleCamera later : online.subList(i + 1, online.size())) {
        overlap += camera.overlap(later);
      }
      confidence += camera.relativeConfidence;
      tracked += camera.tracked;
    }
    double utility = 0.0;
    for (RuleCamera camera : online) {
      utility += camera.utility();
    }
    double proportion = objects.isEmpty() ? 0 : (double) tracked / objects.size();
    return new StepFigures(
        step,
        utility,
        counts.communication,
        0,
        0.0,
        attempts,
        overlap,
        confidence,
        proportion,
        counts.handovers);
  }

  private void drawError() {
    if (errorStream.nextInt(100) > errorLevel) {
      return;
    }
    RuleCamera camera = cameras.get(errorStream.nextInt(cameras.size()));
    camera.online = errorStream.nextInt(10) == 0;
    if (errorStream.nextInt(100) > resetLevel) {
      camera.neighbours.clear();
    }
  }

  private void fire(Element event) {
    String kind = event.getAttribute("participant") + " " + event.getAttribute("event");
    String name = event.getAttribute("name");
    switch (kind) {
      case "object add" -> addObject(RuleObject.added(event));
      case "object error" -> removeObject(List.of(Double.valueOf(name)));
      case "camera add" -> addCamera(event);
      case "camera change" -> online(name).forEach(camera -> camera.change(event));
      case "camera error" -> online(name).forEach(camera -> camera.online = false);
      default -> throw new IllegalArgumentException(kind);
    }
  }

  private List<RuleCamera> online(String name) {
    return cameras.stream().filter(camera -> camera.online && camera.name.equals(name)).toList();
  }

  private void removeObject(List<Double> features) {
    objects.removeIf(object -> object.features.equals(features));
    for (RuleCamera camera : cameras) {
      if (camera.online) {
        camera.visible.keySet().removeIf(object -> object.features.equals(features));
      }
    }
  }
}
