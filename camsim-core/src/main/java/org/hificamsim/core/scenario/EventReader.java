package org.hificamsim.core.scenario;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.hificamsim.core.InputException;

/** Reads events and checks that their story holds: who is added, changed and removed when. */
final class EventReader {
  private final CameraReader cameras;
  private final TargetReader targets;
  private final Consumer<String> warnings;
  private final Faults faults;

  EventReader(
      CameraReader cameras, TargetReader targets, Consumer<String> warnings, Faults faults) {
    this.cameras = cameras;
    this.targets = targets;
    this.warnings = warnings;
    this.faults = faults;
  }

  /**
   * Reads them all: those of the elements, then those that come and go with the tracks.
   *
   * @param start the cameras of the start
   * @param tracks one element at most
   */
  List<ScenarioEvent> events(
      List<CameraSpec> start,
      List<XmlElement> elements,
      List<XmlElement> tracks,
      TracksReader reader) {
    List<Placed> placed = new ArrayList<>(faults.each(elements, this::event));
    faults.each(tracks, reader::events).stream()
        .flatMap(List::stream)
        .forEach(event -> placed.add(new Placed(event, tracks.get(0))));
    if (tracks.size() > 1) {
      faults.check(
          () -> {
            throw tracks.get(1).place().error("a second <tracks>, expected one");
          });
    }
    if (faults.none()) { // else who is missing in the story may be one of those with a fault
      checkTargets(placed);
      checkCameras(placed, start);
    }
    return placed.stream().map(Placed::event).toList();
  }

  private record Placed(ScenarioEvent event, XmlElement element) {
    boolean isOfTracks() {
      return element.name().equals("tracks");
    }
  }

  private Placed event(XmlElement element) {
    Attributes attributes = new Attributes(element);
    int step = attributes.integer("timestep", 0, Integer.MAX_VALUE);
    String participant = attributes.text("participant", "camera, object or grc");
    String kind = attributes.text("event", "add, change or error");
    ScenarioEvent event =
        switch (participant) {
          case "camera" -> cameraEvent(attributes, step, kind);
          case "object" -> targetEvent(element, attributes, step, kind);
          case "grc" -> registrationEvent(attributes, step, kind);
          default -> throw attributes.invalid("participant", "camera, object or grc");
        };
    attributes.leftOver(warnings, "name");
    return new Placed(event, element);
  }

  private ScenarioEvent cameraEvent(Attributes attributes, int step, String kind) {
    return switch (kind) {
      case "add" -> new ScenarioEvent.AddCamera(step, cameras.added(attributes));
      case "change" -> cameras.change(attributes, step);
      case "error" ->
          new ScenarioEvent.FailCamera(
              step,
              attributes.text("name", "the name of a camera"),
              attributes.integer("duration", -1, Integer.MAX_VALUE));
      default -> throw attributes.invalid("event", "add, change or error");
    };
  }

  private ScenarioEvent targetEvent(
      XmlElement element, Attributes attributes, int step, String kind) {
    double identity = attributes.number("name");
    return switch (kind) {
      case "add" -> {
        if (element.attributes().containsKey("move")) {
          warnings.accept(
              element.place("move")
                  + ": an event's move is ignored, as in CamSim (unless camsim --quirks says"
                  + " otherwise); fqName counts");
        }
        yield new ScenarioEvent.AddTarget(step, targets.added(element, attributes, identity));
      }
      case "error" -> new ScenarioEvent.RemoveTarget(step, identity);
      default -> throw attributes.invalid("event", "add or error");
    };
  }

  private static ScenarioEvent registrationEvent(Attributes attributes, int step, String kind) {
    if (!kind.equals("error")) {
      throw attributes.invalid("event", "error");
    }
    return new ScenarioEvent.FailRegistration(
        step, attributes.integer("duration", -1, Integer.MAX_VALUE));
  }

  private void checkTargets(List<Placed> placed) {
    Set<Double> present = targets.present();
    inTime(placed).forEach(one -> faults.check(() -> checkTarget(one, present)));
  }

  private void checkTarget(Placed one, Set<Double> present) {
    if (one.event() instanceof ScenarioEvent.AddTarget add
        && !present.add(add.target().features())) {
      throw taken(one, add);
    }
    if (one.event() instanceof ScenarioEvent.RemoveTarget remove
        && !present.remove(remove.features())
        && !one.isOfTracks()) {
      warnings.accept(
          one.element().place("name")
              + ": no object "
              + remove.features()
              + " is there at step "
              + remove.step()
              + ", nothing is removed");
    }
  }

  private static InputException taken(Placed one, ScenarioEvent.AddTarget add) {
    return one.isOfTracks()
        ? one.element()
            .place()
            .error(
                "target %s of the tracks comes at step %s while another one is there, expected features that no object present has"
                    .formatted(add.target().name(), add.step()))
        : new Attributes(one.element()).invalid("name", "features that no object present has");
  }

  private void checkCameras(List<Placed> placed, List<CameraSpec> start) {
    CameraStory story = new CameraStory(start, cameras, warnings);
    inTime(placed).forEach(one -> faults.check(() -> story.goOn(one.event(), one.element())));
  }

  private static List<Placed> inTime(List<Placed> placed) {
    List<Placed> sorted = new ArrayList<>(placed);
    sorted.sort(Comparator.comparingInt(one -> one.event().step()));
    return sorted;
  }
}
