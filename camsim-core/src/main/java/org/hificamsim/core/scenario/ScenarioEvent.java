package org.hificamsim.core.scenario;

import java.util.List;
import java.util.Optional;

/**
 * Something that happens at the beginning of a step. A further kind is declared here and in {@link
 * #kinds}; {@link org.hificamsim.core.world.World} has what it does.
 */
public sealed interface ScenarioEvent {
  /** All kinds. */
  static List<EventKind<?, ?>> kinds() {
    return List.of(
        AddCamera.KIND,
        ChangeCamera.KIND,
        FailCamera.KIND,
        AddTarget.KIND,
        RemoveTarget.KIND,
        FailRegistration.KIND);
  }

  /** The step at whose beginning it fires, from 0. */
  int step();

  /** The camera that it happens to; empty where it happens to none that is there already. */
  default Optional<String> existingCamera() {
    return Optional.empty();
  }

  /** A camera is added after the existing ones. */
  record AddCamera(int step, CameraSpec camera) implements ScenarioEvent {
    static final EventKind<AddCamera, CameraSpec> KIND =
        new EventKind<>(
            "camera",
            "add",
            AddCamera.class,
            CameraSpec.ADDED,
            (step, said) -> new AddCamera(step, CameraSpec.ADDED.make(said)),
            AddCamera::camera);
  }

  /**
   * A camera is moved, turned or given another range; -1 leaves a value as it is, as in CamSim.
   *
   * @param heading degrees
   * @param viewingAngle degrees
   */
  record ChangeCamera(
      int step,
      String camera,
      double x,
      double y,
      double heading,
      double viewingAngle,
      double range)
      implements ScenarioEvent {
    private static final Element<ChangeCamera> BODY =
        Element.of(
            "event",
            """
            The camera gets these values; -1 leaves one as it was. One with a lens keeps its views.
            name: the camera
            x, y: place, m
            heading, viewing_angle: degrees
            range: reach, m
            """);
    private static final Property<ChangeCamera, String> CAMERA = BODY.required("name", Type.CAMERA);
    static final Property<ChangeCamera, Double> X =
        BODY.required("x", Type.orUnchanged(Type.COORDINATE));
    static final Property<ChangeCamera, Double> Y =
        BODY.required("y", Type.orUnchanged(Type.COORDINATE));
    private static final Property<ChangeCamera, Double> HEADING =
        BODY.required("heading", Type.FINITE);
    private static final Property<ChangeCamera, Double> VIEWING_ANGLE =
        BODY.required("viewing_angle", Type.orUnchanged(Type.OPENING));
    private static final Property<ChangeCamera, Double> RANGE =
        BODY.required("range", Type.orUnchanged(Type.LENGTH));

    static final EventKind<ChangeCamera, ChangeCamera> KIND =
        new EventKind<>(
            "camera", "change", ChangeCamera.class, BODY, ChangeCamera::new, ChangeCamera::said);

    private ChangeCamera(int step, Spec<ChangeCamera> said) {
      this(
          step,
          said.get(CAMERA),
          said.get(X),
          said.get(Y),
          said.get(HEADING),
          said.get(VIEWING_ANGLE),
          said.get(RANGE));
    }

    private Spec<ChangeCamera> said() {
      return BODY.empty()
          .put(CAMERA, camera)
          .put(X, x)
          .put(Y, y)
          .put(HEADING, heading)
          .put(VIEWING_ANGLE, viewingAngle)
          .put(RANGE, range);
    }

    @Override
    public Optional<String> existingCamera() {
      return Optional.of(camera);
    }
  }

  /**
   * A camera goes offline.
   *
   * @param duration steps; any value but 0 means for ever, as in CamSim; 0 does nothing
   */
  record FailCamera(int step, String camera, int duration) implements ScenarioEvent {
    private static final Element<FailCamera> BODY =
        Element.of(
            "event",
            """
            The camera fails.
            name: the camera
            duration: 0 for nothing, any other number of steps for ever, as in CamSim
            """);
    private static final Property<FailCamera, String> CAMERA = BODY.required("name", Type.CAMERA);
    private static final Property<FailCamera, Integer> DURATION =
        BODY.required("duration", Type.whole(-1));

    static final EventKind<FailCamera, FailCamera> KIND =
        new EventKind<>(
            "camera",
            "error",
            FailCamera.class,
            BODY,
            (step, said) -> new FailCamera(step, said.get(CAMERA), said.get(DURATION)),
            fail -> BODY.empty().put(CAMERA, fail.camera).put(DURATION, fail.duration));

    @Override
    public Optional<String> existingCamera() {
      return Optional.of(camera);
    }
  }

  /** A target appears. */
  record AddTarget(int step, TargetSpec target) implements ScenarioEvent {
    static final EventKind<AddTarget, TargetSpec> KIND =
        new EventKind<>(
            "object",
            "add",
            AddTarget.class,
            TargetSpec.ADDED,
            (step, said) -> new AddTarget(step, TargetSpec.ADDED.make(said)),
            AddTarget::target);
  }

  /** The target with these features disappears; without such a target nothing happens. */
  record RemoveTarget(int step, double features) implements ScenarioEvent {
    private static final Element<RemoveTarget> BODY =
        Element.of(
            "event",
            """
            The target leaves.
            name: its features
            """);
    private static final Property<RemoveTarget, Double> FEATURES =
        BODY.required("name", Type.FINITE);

    static final EventKind<RemoveTarget, RemoveTarget> KIND =
        new EventKind<>(
            "object",
            "error",
            RemoveTarget.class,
            BODY,
            (step, said) -> new RemoveTarget(step, said.get(FEATURES)),
            remove -> BODY.empty().put(FEATURES, remove.features));
  }

  /** The global registration goes offline. */
  record FailRegistration(int step, int duration) implements ScenarioEvent {
    private static final Element<FailRegistration> BODY =
        Element.of(
            "event",
            """
            CamSim's global registration fails: see the end.
            duration: steps
            name: of no effect
            """);
    private static final Property<FailRegistration, Integer> DURATION =
        BODY.required("duration", Type.whole(-1));

    static {
      BODY.ignored("name", Type.CAMERA);
    }

    static final EventKind<FailRegistration, FailRegistration> KIND =
        new EventKind<>(
            "grc",
            "error",
            FailRegistration.class,
            BODY,
            (step, said) -> new FailRegistration(step, said.get(DURATION)),
            fail -> BODY.empty().put(DURATION, fail.duration));
  }
}
