package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.reflect.Proxy;
import org.hificamsim.core.policy.OracleView;
import org.junit.jupiter.api.Test;

class CameraMovesTest {
  private final CameraMoves moves = new CameraMoves();

  /** What a camera does in a step; an offline one keeps everything. */
  private record State(int view, double pan, double zoom, boolean moving, boolean online) {}

  private static State at(int view, double degrees, double zoom) {
    return new State(view, Math.toRadians(degrees), zoom, false, true);
  }

  private static State passing(int goal, double degrees, double zoom) {
    return new State(goal, Math.toRadians(degrees), zoom, true, true);
  }

  private static State off(int view) {
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
    step(at(2, 0, 2));
    step(at(2, 0, 2), at(0, 0, 0));
    assertEquals(0, moves.viewChanges());
    step(at(1, 0, 1), at(0, 0, 0), at(1, 0, 1));
    assertEquals(1, moves.viewChanges());
    step(at(1, 0, 1), at(2, 0, 2), at(0, 0, 0));
    assertEquals(3, moves.viewChanges());
    assertEquals(3.0 / 9, moves.viewChangeRate());
  }

  @Test
  void addsUpTravelOfInterruptedMoves() {
    step(at(0, 0, 0));
    step(passing(5, 10, 0.5));
    step(passing(5, 20, 1));
    step(passing(1, 15, 1));
    step(at(1, 15, 1));
    assertEquals(25.0 / 5, moves.meanPanTravel(), 1e-12);
    assertEquals(1.0 / 5, moves.meanZoomTravel(), 1e-12);
    assertEquals(2, moves.viewChanges());
  }

  @Test
  void ignoresOfflineCamerasInMeans() {
    step(at(0, 0, 0), off(0));
    step(at(1, 30, 2), off(0));
    assertEquals(15, moves.meanPanTravel(), 1e-12);
    assertEquals(1, moves.meanZoomTravel(), 1e-12);
  }

  @Test
  void meansAreZeroWithoutSteps() {
    assertEquals(0, moves.meanPanTravel());
    assertEquals(0, moves.viewChangeRate());
  }
}
