package org.hificamsim.presentation.view;

import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioEvent;

/** A scenario with cameras that have been moved, turned and added since it was read. */
final class EditedScenario {
  private static final String ADDED = "added-";

  private final Scenario original;
  private Scenario now;

  EditedScenario(Scenario original) {
    this.original = original;
    this.now = original;
  }

  /** The scenario as it is now. */
  Scenario now() {
    return now;
  }

  /** Makes it the one that was read again. */
  void forget() {
    now = original;
  }

  /**
   * Moves a camera; metres.
   *
   * @throws InputException when the place is not in the field
   */
  void move(String name, double x, double y) {
    checkPlace(x, y);
    now =
        now.withCameras(
            camera ->
                camera.name().equals(name) ? camera.standing(x, y, camera.heading()) : camera);
  }

  /**
   * Turns a camera; degrees.
   *
   * @throws InputException when the heading is not finite
   */
  void turn(String name, double heading) {
    if (!Double.isFinite(heading)) {
      throw new InputException("heading is %s, expected degrees".formatted(heading));
    }
    now =
        now.withCameras(
            camera ->
                camera.name().equals(name)
                    ? camera.standing(camera.x(), camera.y(), heading)
                    : camera);
  }

  /**
   * Adds a camera that is like another one but for its place, after those of the start; metres.
   *
   * @throws InputException when the place is not in the field
   */
  void add(String like, double x, double y) {
    checkPlace(x, y);
    CameraSpec spec = cameras().filter(camera -> camera.name().equals(like)).findFirst().get();
    now = now.withCamera(spec.named(freeName()).standing(x, y, spec.heading()));
  }

  private String freeName() {
    int number = 1;
    while (isTaken(ADDED + number)) {
      number++;
    }
    return ADDED + number;
  }

  private boolean isTaken(String name) {
    return cameras().anyMatch(camera -> camera.name().equals(name));
  }

  /** Those of the start, then those that events add. */
  private Stream<CameraSpec> cameras() {
    Stream<CameraSpec> later =
        now.events().stream()
            .filter(ScenarioEvent.AddCamera.class::isInstance)
            .map(event -> ((ScenarioEvent.AddCamera) event).camera());
    return Stream.concat(now.cameras().stream(), later);
  }

  private void checkPlace(double x, double y) {
    Field field = now.field();
    if (!field.contains(x, y) || Double.isNaN(x) || Double.isNaN(y)) {
      throw new InputException(
          "x is %s and y is %s, expected a place in the field".formatted(x, y));
    }
  }
}
