package org.hificamsim.bridge.run;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.bridge.agent.FaultLine;
import org.hificamsim.bridge.camsim.CamSim;
import org.hificamsim.core.Texts;
import org.hificamsim.core.engine.Behaviour;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.engine.StepPhase;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.World;
import org.hificamsim.runs.Proof;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Traffic;
import org.hificamsim.runs.output.SingleRun;

/**
 * One run of CamSim, from the first step of a {@code SimCore} to its end.
 *
 * <p>CamSim's step is: events, move, cameras look, auctions. The policy decides, and cameras are
 * turned, when the first camera is about to look; the policy learns, and coverage is measured, when
 * the step is over.
 *
 * <p>Policies size their tables when they begin. Where events bring more cameras or targets than
 * were expected then, the policy starts over and has to learn again, which is reported.
 */
final class Run {
  private static final String NO_POLICY = "none";
  private static final String NO_SCENARIO = "camsim";

  private final BridgeSettings settings;
  private final int number;
  private final Object core;
  private final CamSim camsim;
  private final LiveWorld live;
  private final Optional<SingleRun> files;
  private final Optional<TrackedObjects> tracked;
  private Optional<ScenarioFile> scenario = Optional.empty();
  private Simulation simulation; // null before the first step
  private ZoomPolicy policy;
  private Traffic earlier = Traffic.NONE; // of policies that started over
  private Proof earlierProof = Proof.OF_NOTHING;
  private long step;
  private boolean prepared;
  private boolean checked; // that CamSim looks where the tracks have its objects
  private boolean ended;

  /**
   * @param number counts the runs of this JVM, from 0
   */
  Run(BridgeSettings settings, int number, Object core) throws IOException {
    this.settings = settings;
    this.number = number;
    this.core = core;
    this.camsim = new CamSim(core);
    this.live =
        new LiveWorld(
            camsim,
            core,
            Visibility.asInCamSim(settings.seen(), seed()),
            settings.size(),
            settings.views());
    this.tracked = settings.tracks().map(tracks -> new TrackedObjects(tracks, camsim));
    this.policy = newPolicy();
    this.files =
        settings.out().isPresent()
            ? Optional.of(
                new SingleRun(
                    folder(settings.out().get(), number),
                    number,
                    settings.seen(),
                    settings.detail()))
            : Optional.empty();
  }

  /** Whether this is the run of that core. */
  boolean isOf(Object otherCore) {
    return core == otherCore;
  }

  /** CamSim's own {@code SimCore}. */
  Object core() {
    return core;
  }

  /** Counts the runs of this JVM, from 0. */
  int number() {
    return number;
  }

  /** A step begins. */
  void stepBegins() {
    prepared = false;
    tracked.ifPresent(objects -> objects.begin(step));
  }

  /**
   * A camera looks at an object, which CamSim's own visible set of the camera will say.
   *
   * @return the confidence, 0 where it is not visible; NaN where CamSim is to look itself
   */
  double look(Object camera, Object object) {
    prepare();
    if (settings.detection().isEmpty()) {
      return Double.NaN;
    }
    double confidence = live.look(camera, object, step);
    if (!Double.isNaN(confidence)) {
      camsim.setVisible(camera, object, confidence);
    }
    return confidence;
  }

  /** CamSim has looked itself. */
  void looked(Object camera, Object object, double confidence) {
    live.saw(camera, object, confidence > 0);
    if (!checked && tracked.isPresent() && tracked.get().hasLeft(object)) {
      checked = live.agrees(camera, object, confidence);
    }
  }

  /** Where an object is, on one axis. */
  double place(Object object, boolean upwards, double own) {
    return tracked.isPresent() ? tracked.get().place(object, upwards, own) : own;
  }

  /** A step is over. */
  synchronized void stepEnds() {
    prepare();
    simulation.phases().finishStep();
    step++;
  }

  /** Puts the files into place, once. */
  synchronized void end() throws IOException {
    if (!ended) {
      ended = true;
      if (files.isPresent()) {
        try (SingleRun run = files.get()) {
          run.commit(plan(run.steps()), traffic(), proof());
        }
      }
    }
  }

  /** Leaves CamSim as it would be without a policy. */
  void letGo() {
    if (settings.policy().isPresent()) {
      live.restore();
    }
  }

  private void prepare() {
    if (!prepared) {
      prepared = true; // before CamSim is called, which may call back
      readAndSteer();
    }
  }

  private synchronized void readAndSteer() {
    live.refresh();
    if (step == 0) {
      scenario = ScenarioFile.with(live.cameraNames());
      scenario.ifPresent(file -> live.expect(file.allCameras(), file.allTargets()));
      scenario.map(file -> file.question().get("channel")).ifPresent(Run::tell);
    }
    if (!live.fits()) {
      begin();
    }
    simulation.phases().runUntil(StepPhase.OBSERVE);
    if (settings.policy().isPresent()) {
      live.turn();
    }
    live.forget();
  }

  private void begin() {
    if (simulation != null) {
      settings.policy().ifPresent(this::startOver);
    }
    World world = live.begin(settings.objective());
    StepListener listener =
        (network, coverage) ->
            files.filter(open -> !ended).ifPresent(open -> open.stepped(network, coverage));
    simulation =
        new Simulation(
                world, settings.seen(), new Behaviour(policy, live), seed(), List.of(listener))
            .continuingAt(step);
  }

  private void startOver(BridgeSettings.Policy given) {
    FaultLine.note(
        Texts.format(
            "step %s: more cameras or objects than expected: policy %s starts over",
            step, given.spec()));
    earlier = traffic();
    earlierProof = proof().orElse(earlierProof);
    policy = newPolicy();
  }

  private ZoomPolicy newPolicy() {
    return settings.policy().map(given -> given.maker().get()).orElseGet(NoPolicy::new);
  }

  /** What the cameras have sent each other for the policy's sake. */
  private Traffic traffic() {
    return earlier.plus(new Traffic(policy.messages(), policy.bits(), Double.NaN));
  }

  /** What the policies proved; empty for one that does not claim to be the best. */
  private Optional<Proof> proof() {
    return Proof.of(policy).map(earlierProof::plus);
  }

  private static void tell(String channel) {
    FaultLine.note(
        Texts.format(
            "channel is '%s' in the scenario, which has no effect in CamSim: messages"
                + " arrive at once",
            channel));
  }

  private RunPlan plan(int steps) {
    return new RunPlan(
        described(),
        settings.seen(),
        settings.policy().map(BridgeSettings.Policy::spec).orElse(NO_POLICY),
        steps,
        seed(),
        1);
  }

  /** What result files say of the scenario; the field and what moves in it are not asked for. */
  private Scenario described() {
    Field unknown = new Field(Double.NaN, Double.NaN, Double.NaN, Double.NaN);
    return new Scenario(scenario.map(ScenarioFile::name).orElse(NO_SCENARIO), unknown)
        .with(Scenario.OBJECTIVE, settings.objective())
        .with(Scenario.ZOOMS, settings.zooms())
        .with(Scenario.CAMERAS, live.cameraSpecs());
  }

  private long seed() {
    return (long) settings.seed() + number;
  }

  /** The first run's files go into the folder itself, those of run i into {@code run-i} in it. */
  private static Path folder(Path out, int number) {
    return number == 0 ? out : out.resolve("run-" + number);
  }

  /** CamSim chooses the views. */
  private static final class NoPolicy implements ZoomPolicy {
    @Override
    public String name() {
      return NO_POLICY;
    }

    @Override
    public void decide(NetworkView network, int[] views) {}
  }
}
