package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.reflect.Proxy;
import org.hificamsim.core.policy.OracleView;
import org.junit.jupiter.api.Test;

class CameraMovesTest {
  private final CameraMoves moves = new CameraMoves();

  /** The state of a camera in a step; that of an offline camera does not change. */
  private record State(int view, double pan, double zoom, boolean moving, boolean online) {}

  private static State resting(int view, double degrees, double zoom) {
    return new State(view, Math.toRadians(degrees), zoom, false, true);
  }

  private static State passing(int goal, double degrees, double zoom) {
    return new State(goal, Math.toRadians(degrees), zoom, true, true);
  }

  private static State offline(int view) {
    return new State(view, 0, 0, false, false);
  }

  private void step(State... states) {
    moves.add(
        (OracleView)
            Proxy.newProxyInstance(
                OracleView.class.getClassLoader(),
                new Class<?>[] {OracleView.class},
                (proxy, method, arguments) ->
                    switch (method.getName()) {
                      case "cameras" -> states.length;
                      case "view" -> states[(int) arguments[0]].view;
                      case "presentPan" -> states[(int) arguments[0]].pan;
                      case "presentZoom" -> states[(int) arguments[0]].zoom;
                      case "moving" -> states[(int) arguments[0]].moving;
                      case "online" -> states[(int) arguments[0]].online;
                      default -> throw new UnsupportedOperationException(method.getName());
                    }));
  }

  @Test
  void countsViewChangesOfLaterCameras() {
    step(resting(2, 0, 2));
    step(resting(2, 0, 2), resting(0, 0, 0));
    assertEquals(0, moves.viewChanges());
    step(resting(1, 0, 1), resting(0, 0, 0), resting(1, 0, 1));
    assertEquals(1, moves.viewChanges());
    step(resting(1, 0, 1), resting(2, 0, 2), resting(0, 0, 0));
    assertEquals(3, moves.viewChanges());
    assertEquals(3.0 / 9, moves.viewChangeRate());
  }

  @Test
  void addsUpTravelOfInterruptedMoves() {
    step(resting(0, 0, 0));
    step(passing(5, 10, 0.5));
    step(passing(5, 20, 1));
    step(passing(1, 15, 1));
    step(resting(1, 15, 1));
    assertEquals(25.0 / 5, moves.meanPanTravel(), 1e-12);
    assertEquals(1.0 / 5, moves.meanZoomTravel(), 1e-12);
    assertEquals(2, moves.viewChanges());
  }

  @Test
  void ignoresOfflineCamerasInMeans() {
    step(resting(0, 0, 0), offline(0));
    step(resting(1, 30, 2), offline(0));
    assertEquals(15, moves.meanPanTravel(), 1e-12);
    assertEquals(1, moves.meanZoomTravel(), 1e-12);
  }

  @Test
  void meansAreZeroWithoutSteps() {
    assertEquals(0, moves.meanPanTravel());
    assertEquals(0, moves.viewChangeRate());
  }
}
