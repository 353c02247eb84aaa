package org.hificamsim.bridge.camsim;

import java.util.List;
import org.hificamsim.bridge.camsim.Method.Returned;

/** The names of CamSim that the bridge relies on; the misspelt one is CamSim's own. */
final class Names {
  static final String CORE = "epics.camsim.core.SimCore";
  static final String CAMERA = "epics.camsim.core.CameraController";
  static final String OBJECT = "epics.camsim.core.TraceableObject";

  static final Method UPDATE = woven(CORE, "update", List.of(), Returned.ANYTHING);
  static final Method CLOSE_FILES = woven(CORE, "close_files", List.of(), Returned.ANYTHING);
  static final Method LOOK = woven(CAMERA, "update_visiblity", List.of(OBJECT), Returned.NUMBER);

  static final Method CAMERAS = getter(CORE, "getCameras", Returned.SOMETHING);
  static final Method OBJECTS = getter(CORE, "getObjects", Returned.SOMETHING);

  static final Method CAMERA_X = getter(CAMERA, "getX", Returned.NUMBER);
  static final Method CAMERA_Y = getter(CAMERA, "getY", Returned.NUMBER);
  static final Method HEADING = getter(CAMERA, "getHeading", Returned.NUMBER);
  static final Method ANGLE = getter(CAMERA, "getAngle", Returned.NUMBER);
  static final Method RANGE = getter(CAMERA, "getRange", Returned.NUMBER);
  static final Method OFFLINE = getter(CAMERA, "isOffline", Returned.FLAG);
  static final Method CAMERA_NAME = getter(CAMERA, "getName", Returned.SOMETHING);

  static final Method OBJECT_X = getter(OBJECT, "getX", Returned.NUMBER);
  static final Method OBJECT_Y = getter(OBJECT, "getY", Returned.NUMBER);
  static final Method FEATURES = getter(OBJECT, "getFeatures", Returned.SOMETHING);

  static final Method ADD_VISIBLE =
      new Method(CAMERA, "addVisibleObject", List.of(OBJECT, "double"), Returned.ANYTHING, false);
  static final Method REMOVE_VISIBLE =
      new Method(CAMERA, "removeVisibleObject", List.of(OBJECT), Returned.ANYTHING, false);
  static final Method CHANGE =
      new Method(
          CAMERA,
          "change",
          List.of("double", "double", "double", "double", "double"),
          Returned.ANYTHING,
          false);

  /** Needed by any setup. */
  static final List<Method> ALWAYS =
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
  static final List<Method> TO_DETECT = List.of(ADD_VISIBLE, REMOVE_VISIBLE);

  /** Needed to write files. */
  static final List<Method> TO_RECORD = List.of(CLOSE_FILES, FEATURES);

  private Names() {}

  private static Method woven(String type, String name, List<String> parameters, Returned value) {
    return new Method(type, name, parameters, value, true);
  }

  private static Method getter(String type, String name, Returned value) {
    return new Method(type, name, List.of(), value, false);
  }
}
