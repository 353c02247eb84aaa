package org.hificamsim.presentation.view;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.hificamsim.presentation.replay.PackedHeat;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.DetectionSpec;

/**
 * One or two simulations of the same targets that make their steps together. The targets are the
 * same because each world has the same seed and targets move without regard to cameras. The same
 * commands at the same steps give the same results. A command with a wrong value throws an {@link
 * InputException} and leaves the run unchanged. This class is not thread-safe.
 */
public final class LiveRun {
  /**
   * A scenario with its pictures.
   *
   * @param floor pictures to be shown under the field
   */
  public record ShownScenario(Scenario scenario, List<Setup.Floor> floor) {}

  private final Catalogue catalogue;
  private final EditedScenario scenario;
  private final String initialDetection;
  private final DetectionSpec initialSpec;
  private final List<LiveChoice> choices = new ArrayList<>();
  private final List<Setup.Floor> floor;
  private final Map<String, Integer> held = new HashMap<>();
  private final Optional<Planner> planner;
  private final Optional<MeasuredZones> zones;
  private List<LiveSide> sides = new ArrayList<>();
  private long seed;
  private long next;
  private boolean recordsHeat;
  private boolean paused;

  /**
   * @param choice the choice for the first simulation; its detection may be a model file
   * @param planner suggests cameras; empty for no suggestions
   * @throws InputException if the choice is wrong or does not suit the scenario
   */
  public LiveRun(
      Catalogue catalogue,
      ShownScenario shown,
      LiveChoice choice,
      long seed,
      Optional<Planner> planner) {
    this.planner = planner;
    this.zones = planner.map(MeasuredZones::new);
    this.floor = List.copyOf(shown.floor());
    this.catalogue = catalogue;
    this.scenario = new EditedScenario(shown.scenario());
    this.initialDetection = choice.detection();
    this.initialSpec = DetectionSpec.parse(initialDetection, catalogue::detection);
    choices.add(choice);
    restart(seed, true);
  }

  /** Runs one step in each simulation. */
  public LiveStep step() {
    List<LiveStep.Side> results = new ArrayList<>();
    for (LiveSide side : sides) {
      results.add(side.step());
    }
    next++;
    return new LiveStep(results);
  }

  /**
   * Begins again with the same choices.
   *
   * @param newSeed the seed of targets and policies
   * @param keepEdits whether the changes of cameras, targets and walls stay
   */
  public void restart(long newSeed, boolean keepEdits) {
    if (!keepEdits) {
      scenario.reset();
      held.clear();
    }
    seed = newSeed;
    next = 0;
    begin(() -> worldAfter(0));
  }

  private void begin(Supplier<World> world) {
    sides = new ArrayList<>(choices.stream().map(choice -> newSide(world.get(), choice)).toList());
  }

  /** Moves a camera in every simulation, which takes effect in the next step. */
  public void drag(int camera, double x, double y) {
    scenario.move(onlineName(camera), x, y);
    sides.forEach(side -> side.world().moveCamera(camera, x, y));
    recordHeat(recordsHeat);
  }

  /**
   * Turns a camera in every simulation, which takes effect in the next step.
   *
   * @param heading the heading in degrees, 0 is +y and 90 is +x
   */
  public void turn(int camera, double heading) {
    scenario.turn(onlineName(camera), heading);
    sides.forEach(side -> side.world().turnCamera(camera, Math.toRadians(heading)));
    recordHeat(recordsHeat);
  }

  /**
   * Begins a heat map of each simulation with the next step, or stops recording. A heat map begins
   * again whenever a user changes what cameras see.
   */
  public void recordHeat(boolean on) {
    recordsHeat = on;
    sides.forEach(side -> side.recordHeat(on));
  }

  /** Whether heat maps are recorded. */
  public boolean recordsHeat() {
    return recordsHeat;
  }

  /** Returns the heat map of each simulation; empty before the first recorded step. */
  List<PackedHeat> heats() {
    return sides.stream().flatMap(side -> side.heat().stream()).toList();
  }

  /**
   * Adds a copy of a camera to every simulation, after the cameras of the start, as if it had been
   * there from the start. Targets stay where they are; learning begins again. The next step has the
   * poses of all cameras.
   */
  public void addCopy(int original, double x, double y) {
    scenario.addCopy(onlineName(original), x, y);
    rebuild();
  }

  /**
   * Changes the scenario of every simulation, as if it had been so from the start: targets are
   * where they would be then, and learning begins again. The next step has the poses of all
   * cameras.
   */
  void edit(Consumer<EditedScenario> change) {
    change.accept(scenario);
    rebuild();
  }

  /**
   * Moves a camera to the place where it sees the most that others do not see.
   *
   * @param camera the number of the camera; -1 to add a camera at this place
   */
  void suggest(int camera) {
    Optional<CameraSpec> moved =
        camera == -1 ? Optional.empty() : scenario.camera(onlineName(camera));
    CameraSpec suggestion = planner().suggest(scenario.current(), detection(choices.get(0)), moved);
    if (moved.isPresent()) {
      scenario.replace(suggestion);
    } else {
      scenario.add(suggestion);
    }
    rebuildFromScenario();
  }

  private Planner planner() {
    return planner.orElseThrow(() -> new InputException("cameras cannot be planned here"));
  }

  /** Adds a camera that can be bought. */
  void mount(Planner.Mount mount) {
    scenario.add(planner().mounted(mount, scenario.current()));
    rebuildFromScenario();
  }

  /** Adds a zone whose detection is known. */
  void addZone(Zone zone) {
    spec(zone.detection());
    scenario.addZone(zone);
    rebuildFromScenario();
  }

  /** Returns a task that plans cameras for the scenario as it is now. */
  Function<Planner.Watcher, Planner.Plan> planning(Planner.Request request) {
    Planner sitePlanner = planner();
    Scenario site = scenario.current();
    Detection usual = detection(choices.get(0));
    return watcher -> sitePlanner.plan(site, usual, request, watcher);
  }

  /** Returns the zones, with the share of each that the cameras can see from where they are. */
  List<ShownZone> zones() {
    return zones
        .map(measured -> measured.of(scenario.current(), detection(choices.get(0))))
        .orElse(List.of());
  }

  /** Undoes the last change of cameras, targets or walls; learning begins again. */
  public void undo() {
    scenario.undo();
    rebuildFromScenario();
  }

  /** Redoes the change that was undone last; learning begins again. */
  public void redo() {
    scenario.redo();
    rebuildFromScenario();
  }

  /** Returns a warning about the changed scenario; empty if there is none. */
  String warning() {
    List<String> blocked = scenario.blockedTargets();
    return blocked.isEmpty()
        ? ""
        : "the way of target %s leads through a solid obstacle: it walks through%s"
            .formatted(
                blocked.get(0),
                blocked.size() > 1 ? ", as do %s others".formatted(blocked.size() - 1) : "");
  }

  /**
   * Holds a camera in a view in every simulation, from the next step on.
   *
   * @param view -1 to let the policies choose again
   */
  public void hold(int camera, int view) {
    String name = onlineName(camera);
    int views = sides.get(0).world().cameras().views(camera);
    if (view < -1 || view >= views) {
      throw InputException.of("view is %s, expected one from 0 to %s, or -1", view, views - 1);
    }
    if (view < 0) {
      held.remove(name);
    } else {
      held.put(name, view);
    }
    recordHeat(recordsHeat);
  }

  /** The cameras that are held in a view. */
  List<Integer> held() {
    Cameras cameras = sides.get(0).world().cameras();
    return IntStream.range(0, cameras.count())
        .filter(camera -> held.containsKey(cameras.name(camera)))
        .boxed()
        .toList();
  }

  /** Sets whether changes of the scenario repeat the last step instead of making the next one. */
  void setPaused(boolean newPaused) {
    paused = newPaused;
  }

  private void rebuild() {
    World before = sides.get(0).world();
    stepBackIfPaused();
    begin(() -> worldLike(before));
  }

  /** Begins again; all cameras are where the scenario has them. */
  private void rebuildFromScenario() {
    stepBackIfPaused();
    begin(() -> worldAfter(next));
  }

  /** Goes back a step if the session is paused, so that the next step repeats the shown one. */
  private void stepBackIfPaused() {
    next = Math.max(0, next - (paused ? 1 : 0));
  }

  /**
   * Returns the name of a camera.
   *
   * @throws InputException if it is not online
   */
  private String onlineName(int camera) {
    Cameras cameras = sides.get(0).world().cameras();
    if (camera < 0 || camera >= cameras.count() || !cameras.online(camera)) {
      throw new InputException(
          "camera is %s, expected the number of one that is online".formatted(camera));
    }
    return cameras.name(camera);
  }

  /**
   * Gives a simulation another model, threshold or policy. Targets stay where they are; learning
   * begins again.
   */
  public void choose(int side, LiveChoice choice) {
    if (side < 0 || side >= sides.size()) {
      throw InputException.of("side is %s, expected one from 0 to %s", side, sides.size() - 1);
    }
    sides.set(side, newSide(sides.get(side).world(), choice));
    choices.set(side, choice);
    zones.ifPresent(MeasuredZones::forget);
  }

  /**
   * Adds a second simulation of the same targets, with the first one's choice, or removes it. The
   * next step has the poses of all cameras.
   */
  public void compare(boolean on) {
    if (on && sides.size() == 1) {
      World world = worldLike(sides.get(0).world());
      sides.add(newSide(world, choices.get(0)));
      choices.add(choices.get(0));
    } else if (!on && sides.size() == 2) {
      sides.remove(1);
      choices.remove(1);
    }
    sides.forEach(LiveSide::sendAllPoses);
  }

  /** Returns a new world after this many steps. */
  private World worldAfter(long steps) {
    World world = new World(scenario.current(), catalogue.movements(), seed);
    for (long step = 0; step < steps; step++) {
      world.fireEvents(step);
      world.moveTargets();
    }
    return world;
  }

  /** Returns a new world before the next step, with cameras where they are in another one. */
  private World worldLike(World other) {
    World world = worldAfter(next);
    Map<String, Integer> numbers = new HashMap<>();
    for (int camera = 0; camera < world.cameras().count(); camera++) {
      numbers.put(world.cameras().name(camera), camera);
    }
    Cameras cameras = other.cameras();
    for (int camera = 0; camera < cameras.count(); camera++) {
      Integer number = numbers.get(cameras.name(camera));
      if (cameras.online(camera) && number != null) {
        world.moveCamera(number, cameras.x(camera), cameras.y(camera));
        world.turnCamera(number, cameras.heading(camera));
      }
    }
    return world;
  }

  private LiveSide newSide(World world, LiveChoice choice) {
    LiveSide.Shared shared = new LiveSide.Shared(catalogue, seed, next, floor, held);
    LiveSide side = new LiveSide(world, detection(choice), choice.policy(), shared);
    side.recordHeat(recordsHeat);
    return side;
  }

  private Detection detection(LiveChoice choice) {
    Scenario current = scenario.current();
    return spec(choice.detection()).detection(choice.settings(current), current);
  }

  /**
   * Returns the detection with a name, which has to be in the catalogue, or the one that the
   * session began with: pages must not make the server read files.
   */
  private DetectionSpec spec(String name) {
    return name.equals(initialDetection)
        ? initialSpec
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

  /** The scenario with all changes. */
  Scenario scenario() {
    return scenario.current();
  }
}
