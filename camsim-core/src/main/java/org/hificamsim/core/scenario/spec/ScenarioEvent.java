package org.hificamsim.core.scenario.spec;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.scenario.declaration.Type;

/**
 * Something that happens at the beginning of a step. A further kind is declared here and in {@link
 * #kinds}; {@link org.hificamsim.core.world.World} has what it does.
 */
public sealed interface ScenarioEvent {
  /** Returns all kinds of events. */
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

  /** The existing camera that the event concerns; empty if there is none. */
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
            (step, spec) -> new AddCamera(step, CameraSpec.ADDED.make(spec)),
            AddCamera::camera);
  }

  /**
   * A camera is moved, turned or given another range; -1 leaves a value as it is, as in CamSim.
   *
   * @param heading the heading, in degrees
   * @param viewingAngle the viewing angle, in degrees
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
    static final EventKind<ChangeCamera, ChangeCamera> KIND =
        EventKind.of(
            "camera",
            "change",
            ChangeCamera.class,
            """
            The camera gets these values; -1 leaves one as it was. One with a lens keeps its views.
            name: the camera
            x, y: place, m
            heading, viewing_angle: degrees
            range: reach, m
            """,
            body ->
                body.requires(Type.CAMERA, "name")
                    .requires(Type.orUnchanged(Type.COORDINATE), "x", "y")
                    .requires(Type.FINITE, "heading")
                    .requires(Type.orUnchanged(Type.OPENING), "viewing_angle")
                    .requires(Type.orUnchanged(Type.LENGTH), "range"));

    @Override
    public Optional<String> existingCamera() {
      return Optional.of(camera);
    }
  }

  /**
   * A camera goes offline.
   *
   * @param duration the duration, in steps; any value except 0 means permanently, as in CamSim; 0
   *     does nothing
   */
  record FailCamera(int step, String camera, int duration) implements ScenarioEvent {
    static final EventKind<FailCamera, FailCamera> KIND =
        EventKind.of(
            "camera",
            "error",
            FailCamera.class,
            """
            The camera fails.
            name: the camera
            duration: 0 for nothing, any other number of steps for ever, as in CamSim
            """,
            body -> body.requires(Type.CAMERA, "name").requires(Type.whole(-1), "duration"));

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
            (step, spec) -> new AddTarget(step, TargetSpec.ADDED.make(spec)),
            AddTarget::target);
  }

  /** The target with these features disappears; without such a target nothing happens. */
  record RemoveTarget(int step, double features) implements ScenarioEvent {
    static final EventKind<RemoveTarget, RemoveTarget> KIND =
        EventKind.of(
            "object",
            "error",
            RemoveTarget.class,
            """
            The target leaves.
            name: its features
            """,
            body -> body.requires(Type.FINITE, "name"));
  }

  /** The global registration goes offline. */
  record FailRegistration(int step, int duration) implements ScenarioEvent {
    static final EventKind<FailRegistration, FailRegistration> KIND =
        EventKind.of(
            "grc",
            "error",
            FailRegistration.class,
            """
            CamSim's global registration fails: see the end.
            duration: steps
            name: of no effect
            """,
            body -> body.requires(Type.whole(-1), "duration").ignored("name", Type.CAMERA));
  }
}
