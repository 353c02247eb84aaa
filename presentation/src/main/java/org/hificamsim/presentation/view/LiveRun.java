package org.hificamsim.presentation.view;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;
import org.hificamsim.presentation.replay.PackedHeat;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.DetectionSpec;

/**
 * One or two simulations of the same targets, in step. The targets are the same because each world
 * has the same seed and targets move without regard to cameras. Equal commands between equal steps
 * give equal steps. A command with a wrong value throws an {@link InputException}, and nothing has
 * changed then. Not for several threads.
 */
public final class LiveRun {
  private final Catalogue catalogue;
  private final EditedScenario scenario;
  private final String firstName;
  private final DetectionSpec first;
  private final List<LiveChoice> choices = new ArrayList<>();
  private final List<Setup.Floor> floor;
  private final Map<String, Integer> held = new HashMap<>();
  private final Optional<Planner> planner;
  private List<LiveSide> sides = new ArrayList<>();
  private List<Planner.Share> shares = List.of();
  private Scenario shared; // of which these are
  private long seed;
  private long next;
  private boolean heat;
  private boolean paused;

  /**
   * @param choice of the first simulation; its detection may be a model file
   * @param floor pictures under the field
   * @param planner suggests cameras; empty for no suggestions
   * @throws InputException when the choice is wrong or does not suit the scenario
   */
  public LiveRun(
      Catalogue catalogue,
      Scenario scenario,
      LiveChoice choice,
      long seed,
      List<Setup.Floor> floor,
      Optional<Planner> planner) {
    this.planner = planner;
    this.floor = List.copyOf(floor);
    this.catalogue = catalogue;
    this.scenario = new EditedScenario(scenario);
    this.firstName = choice.detection();
    this.first = DetectionSpec.parse(firstName, catalogue::detection);
    choices.add(choice);
    restart(seed, true);
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
   * Begins again with the same choices.
   *
   * @param newSeed of targets and policies
   * @param keepEdits whether cameras and walls stay as they were put; else all is as the scenario
   *     says
   */
  public void restart(long newSeed, boolean keepEdits) {
    if (!keepEdits) {
      scenario.forget();
      held.clear();
    }
    seed = newSeed;
    next = 0;
    begin(() -> world(0));
  }

  private void begin(Supplier<World> world) {
    sides = new ArrayList<>(choices.stream().map(choice -> side(world.get(), choice)).toList());
  }

  /** Puts a camera elsewhere in every simulation; seen from the next step on. */
  public void drag(int camera, double x, double y) {
    scenario.move(online(camera), x, y);
    sides.forEach(side -> side.world().moveCamera(camera, x, y));
    heat(heat);
  }

  /**
   * Turns a camera in every simulation; seen from the next step on.
   *
   * @param heading degrees, 0 is +y and 90 is +x
   */
  public void turn(int camera, double heading) {
    scenario.turn(online(camera), heading);
    sides.forEach(side -> side.world().turnCamera(camera, Math.toRadians(heading)));
    heat(heat);
  }

  /**
   * Makes a heat map of each simulation from the next step on, or none any more. It begins again
   * whenever somebody changes what cameras see.
   */
  public void heat(boolean on) {
    heat = on;
    sides.forEach(side -> side.heat(on));
  }

  /** Whether there is a heat map. */
  public boolean heat() {
    return heat;
  }

  /** The heat map of each simulation; none before the first step of each. */
  List<PackedHeat> heats() {
    return sides.stream().flatMap(side -> side.heat().stream()).toList();
  }

  /**
   * Adds a camera to every simulation, as if it had been there from the start: the targets go on,
   * learning begins again. It comes after the cameras of the start. The next step says where every
   * camera is.
   *
   * @param like number of the camera that has its kind and heading
   */
  public void add(int like, double x, double y) {
    scenario.add(online(like), x, y);
    rebuild();
  }

  /**
   * Adds or takes away something in every simulation, as if it had been so from the start: targets
   * are where they would be then, learning begins again. The next step says where every camera is.
   */
  void edit(Consumer<EditedScenario> change) {
    change.accept(scenario);
    rebuild();
  }

  /**
   * Puts a camera where it sees the most that others do not.
   *
   * @param camera its number; -1 for one more
   */
  void suggest(int camera) {
    Optional<CameraSpec> moved = camera == -1 ? Optional.empty() : scenario.camera(online(camera));
    CameraSpec found =
        planner
            .orElseThrow(() -> new InputException("nothing plans cameras here"))
            .suggest(scenario.now(), detection(choices.get(0)), moved);
    scenario.put(found, moved.isEmpty());
    rebuildAsWritten();
  }

  /** What cameras can see of each zone where they are now; nothing where it is not known. */
  List<Planner.Share> shares() {
    if (planner.isPresent() && !scenario.now().equals(shared)) {
      shared = scenario.now();
      try {
        shares = planner.get().shares(shared, detection(choices.get(0)));
      } catch (InputException e) {
        shares = List.of(); // by chance
      }
    }
    return shares;
  }

  /** Takes the last change of cameras, targets or walls back; learning begins again. */
  public void undo() {
    scenario.undo();
    rebuildAsWritten();
  }

  /** Makes the change again that was taken back last. */
  public void redo() {
    scenario.redo();
    rebuildAsWritten();
  }

  /** What is odd about the scenario as it is now; perhaps nothing. */
  String warning() {
    List<String> blocked = scenario.blocked();
    return blocked.isEmpty()
        ? ""
        : "the way of target %s leads through a solid obstacle: it walks through%s"
            .formatted(
                blocked.get(0),
                blocked.size() > 1 ? ", as do %s others".formatted(blocked.size() - 1) : "");
  }

  /**
   * Has a camera stay in a view in every simulation, from the next step on.
   *
   * @param view -1 to leave it to the policies again
   */
  public void hold(int camera, int view) {
    String name = online(camera);
    int views = sides.get(0).world().cameras().views(camera);
    if (view < -1 || view >= views) {
      throw InputException.of("view is %s, expected one from 0 to %s, or -1", view, views - 1);
    }
    if (view < 0) {
      held.remove(name);
    } else {
      held.put(name, view);
    }
    heat(heat);
  }

  /** The cameras that are held in a view. */
  List<Integer> held() {
    Cameras cameras = sides.get(0).world().cameras();
    return IntStream.range(0, cameras.count())
        .filter(camera -> held.containsKey(cameras.name(camera)))
        .boxed()
        .toList();
  }

  /** Whether a change of what is there makes the last step again, and not the next one. */
  void paused(boolean now) {
    paused = now;
  }

  private void rebuild() {
    World before = sides.get(0).world();
    again();
    begin(() -> worldAs(before));
  }

  /** The same with cameras where the scenario has them. */
  private void rebuildAsWritten() {
    again();
    begin(() -> world(next));
  }

  /** While nobody lets time pass, the step that is shown comes next again. */
  private void again() {
    next = Math.max(0, next - (paused ? 1 : 0));
  }

  /** The name of a camera that is online. */
  private String online(int camera) {
    Cameras cameras = sides.get(0).world().cameras();
    if (camera < 0 || camera >= cameras.count() || !cameras.online(camera)) {
      throw new InputException("camera is %s, expected one that is online".formatted(camera));
    }
    return cameras.name(camera);
  }

  /**
   * Gives a simulation another model, threshold or policy: the targets go on, learning begins
   * again.
   */
  public void choose(int side, LiveChoice choice) {
    if (side < 0 || side >= sides.size()) {
      throw InputException.of("side is %s, expected one from 0 to %s", side, sides.size() - 1);
    }
    sides.set(side, side(sides.get(side).world(), choice));
    choices.set(side, choice);
    shared = null;
  }

  /**
   * Adds a second simulation of the same targets, with the first one's choice, or removes it. The
   * next step says where every camera is.
   */
  public void compare(boolean on) {
    if (on && sides.size() == 1) {
      World world = worldAs(sides.get(0).world());
      sides.add(side(world, choices.get(0)));
      choices.add(choices.get(0));
    } else if (!on && sides.size() == 2) {
      sides.remove(1);
      choices.remove(1);
    }
    sides.forEach(LiveSide::tellPosesAgain);
  }

  /** A new world after this many steps. */
  private World world(long steps) {
    World world = new World(scenario.now(), catalogue.movements(), seed);
    for (long step = 0; step < steps; step++) {
      world.fireEvents(step);
      world.moveTargets();
    }
    return world;
  }

  /** A new world of the same step, with cameras where they are in another one. */
  private World worldAs(World other) {
    World world = world(next);
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

  private LiveSide side(World world, LiveChoice choice) {
    LiveSide side =
        new LiveSide(world, catalogue, detection(choice), choice.policy(), seed, next, floor, held);
    side.heat(heat);
    return side;
  }

  private Detection detection(LiveChoice choice) {
    return spec(choice.detection()).detection(choice.asked(scenario.now()), scenario.now());
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

  /** The scenario with its cameras and walls as they were put. */
  Scenario scenario() {
    return scenario.now();
  }
}
