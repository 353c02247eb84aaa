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
 * <p>In a step of CamSim, events happen, objects move, cameras look, and auctions are held. The
 * policy decides, and cameras are turned, when the first camera is about to look. The policy
 * learns, and coverage is measured, when the step is over.
 *
 * <p>Policies allocate their tables when they begin. If events add more cameras or targets than
 * were expected then, a new policy begins and learns from scratch, which is reported.
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

  /** The simulation; null before the first step. */
  private Simulation simulation;

  private ZoomPolicy policy;

  /** The traffic of policies that were replaced. */
  private Traffic earlierTraffic = Traffic.NONE;

  private Proof earlierProof = Proof.NO_STEPS;
  private long step;
  private boolean prepared;

  /** Whether it was checked that CamSim looks at objects on their tracks. */
  private boolean tracksChecked;

  private boolean ended;

  /**
   * @param number the number of the run in this JVM, from 0
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
            Visibility.asInCamSim(settings.detectionOrCamSim(), seed()),
            settings.size(),
            settings.cameraViews());
    this.tracked = settings.tracks().map(tracks -> new TrackedObjects(tracks, camsim));
    this.policy = newPolicy();
    this.files =
        settings.out().isPresent()
            ? Optional.of(
                new SingleRun(
                    folder(settings.out().get(), number),
                    number,
                    settings.detectionOrCamSim(),
                    settings.detail(),
                    settings.following()))
            : Optional.empty();
  }

  /** Returns whether this is the run of a core. */
  boolean isOf(Object otherCore) {
    return core == otherCore;
  }

  /** The {@code SimCore} of CamSim. */
  Object core() {
    return core;
  }

  /** The number of the run in this JVM, from 0. */
  int number() {
    return number;
  }

  /** Called when a step begins. */
  void stepBegins() {
    prepared = false;
    tracked.ifPresent(objects -> objects.begin(step));
  }

  /**
   * Lets a camera look at an object, and updates the set of objects that CamSim's camera sees.
   *
   * @return the confidence, 0 if the object is not visible; NaN if CamSim has to look itself
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

  /** Records that CamSim has looked itself. */
  void looked(Object camera, Object object, double confidence) {
    live.recordLook(camera, object, confidence > 0);
    if (!tracksChecked && tracked.isPresent() && tracked.get().hasLeft(object)) {
      tracksChecked = live.checkTrack(camera, object, confidence);
    }
  }

  /** Returns a coordinate of an object. */
  double coordinate(Object object, boolean isY, double camSimValue) {
    return tracked.isPresent() ? tracked.get().coordinate(object, isY, camSimValue) : camSimValue;
  }

  /** Called when a step ends. */
  synchronized void stepEnds() {
    prepare();
    simulation.phases().finishStep();
    step++;
  }

  /** Commits the files; further calls have no effect. */
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

  /** Restores the aims that the cameras would have without a policy. */
  void releaseCamSim() {
    if (settings.policy().isPresent()) {
      live.restoreCameras();
    }
  }

  private void prepare() {
    if (!prepared) {
      // set before the calls to CamSim, which may call back
      prepared = true;
      readAndSteer();
    }
  }

  private synchronized void readAndSteer() {
    live.refresh();
    if (step == 0) {
      scenario = ScenarioFile.with(live.cameraNames());
      scenario.ifPresent(file -> live.expect(file.allCameras(), file.allTargets()));
      scenario.map(file -> file.attributes().get("channel")).ifPresent(Run::warnAboutChannel);
    }
    if (!live.hasCapacity()) {
      begin();
    }
    simulation.phases().runUntil(StepPhase.OBSERVE);
    if (settings.policy().isPresent()) {
      live.turnCameras();
    }
    live.forgetSightings();
  }

  private void begin() {
    if (simulation != null) {
      settings.policy().ifPresent(this::startOver);
    }
    World world = live.begin(settings.objective());
    StepListener listener =
        (network, coverage) -> {
          if (!ended && files.isPresent()) {
            files.get().stepped(network, coverage);
          }
        };
    simulation =
        new Simulation(
                world,
                settings.detectionOrCamSim(),
                new Behaviour(policy, live),
                seed(),
                List.of(listener))
            .continuingAt(step);
  }

  private void startOver(BridgeSettings.Policy given) {
    FaultLine.note(
        Texts.format(
            "step %s: more cameras or objects than expected: policy %s starts over",
            step, given.spec()));
    earlierTraffic = traffic();
    earlierProof = proof().orElse(earlierProof);
    policy = newPolicy();
  }

  private ZoomPolicy newPolicy() {
    return settings.policy().map(given -> given.maker().get()).orElseGet(NoPolicy::new);
  }

  /** The traffic of the policies so far. */
  private Traffic traffic() {
    return earlierTraffic.plus(new Traffic(policy.messages(), policy.bits(), Double.NaN));
  }

  /** The proof of the policies so far; empty if the policy does not claim an optimum. */
  private Optional<Proof> proof() {
    return Proof.of(policy).map(earlierProof::plus);
  }

  private static void warnAboutChannel(String channel) {
    FaultLine.note(
        Texts.format(
            "channel is '%s' in the scenario, which has no effect in CamSim: messages"
                + " arrive at once",
            channel));
  }

  private RunPlan plan(int steps) {
    return new RunPlan(
        describedScenario(),
        settings.detectionOrCamSim(),
        settings.policy().map(BridgeSettings.Policy::spec).orElse(NO_POLICY),
        steps,
        seed(),
        1);
  }

  /** Returns the scenario for the result files, without field and targets. */
  private Scenario describedScenario() {
    Field unknown = new Field(Double.NaN, Double.NaN, Double.NaN, Double.NaN);
    return new Scenario(scenario.map(ScenarioFile::name).orElse(NO_SCENARIO), unknown)
        .with(Scenario.OBJECTIVE, settings.objective())
        .with(Scenario.FOLLOWING, settings.following())
        .with(Scenario.ZOOMS, settings.zooms())
        .with(Scenario.CAMERAS, live.cameraSpecs());
  }

  private long seed() {
    return (long) settings.seed() + number;
  }

  /**
   * Returns the folder of a run: {@code out} for the first run, its subfolder {@code run-i} for run
   * i.
   */
  private static Path folder(Path out, int number) {
    return number == 0 ? out : out.resolve("run-" + number);
  }

  /** Leaves the choice of views to CamSim. */
  private static final class NoPolicy implements ZoomPolicy {
    @Override
    public String name() {
      return NO_POLICY;
    }

    @Override
    public void decide(NetworkView network, int[] views) {}
  }
}
