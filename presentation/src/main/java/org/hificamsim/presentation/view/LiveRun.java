package org.hificamsim.presentation.view;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Overrides;

/**
 * One or two simulations of the same targets, in step. The targets are the same because each world
 * has the same seed and targets move without regard to cameras. Equal commands between equal steps
 * give equal steps. Not for several threads.
 */
public final class LiveRun {
  /** A camera that has been dragged; metres. */
  private record Place(double x, double y) {}

  private final Catalogue catalogue;
  private final Scenario scenario;
  private final String firstName;
  private final DetectionSpec first;
  private final Map<Integer, Place> dragged = new TreeMap<>();
  private final List<Choice> choices = new ArrayList<>();
  private List<LiveSide> sides = new ArrayList<>();
  private long seed;
  private long next;

  /**
   * @param choice of the first simulation; its detection may be a model file
   * @throws InputException when the choice is wrong or does not suit the scenario
   */
  public LiveRun(Catalogue catalogue, Scenario scenario, Choice choice, long seed) {
    this.catalogue = catalogue;
    this.scenario = scenario;
    this.firstName = choice.detection();
    this.first = DetectionSpec.parse(firstName, catalogue::detection);
    choices.add(choice);
    restart(seed);
  }

  /** Runs one step in each simulation. */
  public LiveStep step() {
    List<LiveStep.Side> done = new ArrayList<>();
    for (LiveSide side : sides) {
      done.add(side.step());
    }
    next++;
    return new LiveStep(done);
  }

  /**
   * Begins anew with the same choices, dragged cameras where they were dragged to.
   *
   * @param newSeed of targets and policies
   */
  public void restart(long newSeed) {
    List<LiveSide> begun = new ArrayList<>();
    for (Choice choice : choices) {
      World world = new World(scenario, catalogue.movements(), newSeed);
      place(world);
      begun.add(side(world, choice, newSeed, 0));
    }
    sides = begun;
    seed = newSeed;
    next = 0;
  }

  /** Has cameras begin where the scenario says, from the next restart on. */
  public void forgetDragged() {
    dragged.clear();
  }

  /**
   * Puts a camera elsewhere in every simulation; seen from the next step on.
   *
   * @throws InputException when there is no such camera online, or the place is not in the field
   */
  public void drag(int camera, double x, double y) {
    Cameras cameras = sides.get(0).world().cameras();
    if (camera < 0 || camera >= cameras.count() || !cameras.online(camera)) {
      throw new InputException("camera is %s, expected one that is online".formatted(camera));
    }
    Field field = scenario.field();
    if (!field.contains(x, y) || Double.isNaN(x) || Double.isNaN(y)) {
      throw new InputException(
          "x is %s and y is %s, expected a place in the field".formatted(x, y));
    }
    dragged.put(camera, new Place(x, y));
    sides.forEach(side -> side.world().moveCamera(camera, x, y));
  }

  /**
   * Gives a simulation another model, threshold or policy: the targets go on, learning begins anew.
   *
   * @throws InputException when the choice is wrong; nothing has changed then
   */
  public void choose(int side, Choice choice) {
    if (side < 0 || side >= sides.size()) {
      throw new InputException(
          "side is %s, expected one from 0 to %s".formatted(side, sides.size() - 1));
    }
    sides.set(side, side(sides.get(side).world(), choice, seed, next));
    choices.set(side, choice);
  }

  /**
   * Adds a second simulation of the same targets, with the first one's choice, or removes it. The
   * next step tells where every camera is.
   */
  public void compare(boolean on) {
    if (on && sides.size() == 1) {
      World world = new World(scenario, catalogue.movements(), seed);
      for (long step = 0; step < next; step++) {
        world.fireEvents(step);
        world.moveTargets();
      }
      standAs(sides.get(0).world().cameras(), world);
      sides.add(side(world, choices.get(0), seed, next));
      choices.add(choices.get(0));
    } else if (!on && sides.size() == 2) {
      sides.remove(1);
      choices.remove(1);
    }
    sides.forEach(LiveSide::tellPosesAgain);
  }

  private void place(World world) {
    dragged.forEach(
        (camera, place) -> {
          if (world.cameras().online(camera)) {
            world.moveCamera(camera, place.x(), place.y());
          }
        });
  }

  private static void standAs(Cameras first, World world) {
    for (int camera = 0; camera < first.count(); camera++) {
      if (first.online(camera)) {
        world.moveCamera(camera, first.x(camera), first.y(camera));
      }
    }
  }

  private LiveSide side(World world, Choice choice, long ofSeed, long at) {
    Detection detection =
        Overrides.ofDetection(Optional.ofNullable(choice.threshold()), Optional.empty())
            .detection(spec(choice.detection()), scenario);
    return new LiveSide(world, catalogue, detection, choice.policy(), ofSeed, at);
  }

  /** A page may name what the catalogue has, and the file that the session began with. */
  private DetectionSpec spec(String name) {
    return name.equals(firstName)
        ? first
        : DetectionSpec.parse(name, catalogue.detections()::create);
  }

  List<LiveSide> sides() {
    return sides;
  }

  /** The step that comes next, from 0. */
  public long next() {
    return next;
  }

  public long seed() {
    return seed;
  }

  Scenario scenario() {
    return scenario;
  }
}
