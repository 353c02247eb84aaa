package org.hificamsim.bridge.camsim;

import java.util.List;
import org.hificamsim.bridge.camsim.CamSimMethod.Returned;

/** The names of CamSim that the bridge relies on; the misspelt one is CamSim's own. */
final class Names {
  static final String CORE = "epics.camsim.core.SimCore";
  static final String CAMERA = "epics.camsim.core.CameraController";
  static final String OBJECT = "epics.camsim.core.TraceableObject";

  static final CamSimMethod UPDATE = woven(CORE, "update", List.of(), Returned.ANYTHING);
  static final CamSimMethod CLOSE_FILES = woven(CORE, "close_files", List.of(), Returned.ANYTHING);
  static final CamSimMethod LOOK =
      woven(CAMERA, "update_visiblity", List.of(OBJECT), Returned.NUMBER);

  static final CamSimMethod CAMERAS = getter(CORE, "getCameras", Returned.SOMETHING);
  static final CamSimMethod OBJECTS = getter(CORE, "getObjects", Returned.SOMETHING);

  static final CamSimMethod CAMERA_X = getter(CAMERA, "getX", Returned.NUMBER);
  static final CamSimMethod CAMERA_Y = getter(CAMERA, "getY", Returned.NUMBER);
  static final CamSimMethod HEADING = getter(CAMERA, "getHeading", Returned.NUMBER);
  static final CamSimMethod ANGLE = getter(CAMERA, "getAngle", Returned.NUMBER);
  static final CamSimMethod RANGE = getter(CAMERA, "getRange", Returned.NUMBER);
  static final CamSimMethod OFFLINE = getter(CAMERA, "isOffline", Returned.FLAG);
  static final CamSimMethod CAMERA_NAME = getter(CAMERA, "getName", Returned.SOMETHING);

  static final CamSimMethod OBJECT_X = getter(OBJECT, "getX", Returned.NUMBER);
  static final CamSimMethod OBJECT_Y = getter(OBJECT, "getY", Returned.NUMBER);
  static final CamSimMethod FEATURES = getter(OBJECT, "getFeatures", Returned.SOMETHING);

  static final CamSimMethod ADD_VISIBLE =
      new CamSimMethod(
          CAMERA, "addVisibleObject", List.of(OBJECT, "double"), Returned.ANYTHING, false);
  static final CamSimMethod REMOVE_VISIBLE =
      new CamSimMethod(CAMERA, "removeVisibleObject", List.of(OBJECT), Returned.ANYTHING, false);
  static final CamSimMethod CHANGE =
      new CamSimMethod(
          CAMERA,
          "change",
          List.of("double", "double", "double", "double", "double"),
          Returned.ANYTHING,
          false);

  /** Needed to have objects follow tracks: what is woven has to be in the class itself. */
  static final CamSimMethod TRACKED_X = woven(OBJECT, "getX", List.of(), Returned.NUMBER);

  static final CamSimMethod TRACKED_Y = woven(OBJECT, "getY", List.of(), Returned.NUMBER);

  /** Needed by any setup. */
  static final List<CamSimMethod> ALWAYS =
      List.of(
          UPDATE,
          CAMERAS,
          OBJECTS,
          LOOK,
          CAMERA_X,
          CAMERA_Y,
          HEADING,
          ANGLE,
          RANGE,
          OFFLINE,
          CAMERA_NAME,
          OBJECT_X,
          OBJECT_Y);

  /** Needed to decide what cameras see. */
  static final List<CamSimMethod> TO_DETECT = List.of(ADD_VISIBLE, REMOVE_VISIBLE);

  /** Needed to write files. */
  static final List<CamSimMethod> TO_RECORD = List.of(CLOSE_FILES, FEATURES);

  /** Needed to have objects follow tracks. */
  static final List<CamSimMethod> TO_TRACK = List.of(TRACKED_X, TRACKED_Y, FEATURES);

  private Names() {}

  private static CamSimMethod woven(
      String type, String name, List<String> parameters, Returned value) {
    return new CamSimMethod(type, name, parameters, value, true);
  }

  private static CamSimMethod getter(String type, String name, Returned value) {
    return new CamSimMethod(type, name, List.of(), value, false);
  }
}
