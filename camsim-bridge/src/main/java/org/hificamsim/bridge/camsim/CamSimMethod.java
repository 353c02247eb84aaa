package org.hificamsim.bridge.camsim;

import java.lang.invoke.MethodType;
import java.util.List;
import java.util.stream.Collectors;

/**
 * The instance methods of CamSim that the bridge calls or changes. Their names are CamSim's own,
 * one of which is misspelt.
 */
enum CamSimMethod {
  UPDATE(Type.CORE, "update", void.class, Use.READ, Advices.Step.class),
  CLOSE_FILES(Type.CORE, "close_files", void.class, Use.RECORD, Advices.End.class),
  CAMERAS(Type.CORE, "getCameras", Object.class, Use.READ),
  OBJECTS(Type.CORE, "getObjects", Object.class, Use.READ),
  LOOK(
      Type.CAMERA,
      "update_visiblity",
      double.class,
      Use.READ,
      Advices.Look.class,
      Type.OBJECT.name),
  CAMERA_X(Type.CAMERA, "getX", double.class, Use.READ),
  CAMERA_Y(Type.CAMERA, "getY", double.class, Use.READ),
  HEADING(Type.CAMERA, "getHeading", double.class, Use.READ),
  ANGLE(Type.CAMERA, "getAngle", double.class, Use.READ),
  RANGE(Type.CAMERA, "getRange", double.class, Use.READ),
  OFFLINE(Type.CAMERA, "isOffline", boolean.class, Use.READ),
  CAMERA_NAME(Type.CAMERA, "getName", Object.class, Use.READ),
  ADD_VISIBLE(
      Type.CAMERA, "addVisibleObject", void.class, Use.DETECT, null, Type.OBJECT.name, "double"),
  REMOVE_VISIBLE(
      Type.CAMERA, "removeVisibleObject", void.class, Use.DETECT, null, Type.OBJECT.name),
  CHANGE(
      Type.CAMERA,
      "change",
      void.class,
      Use.STEER,
      null,
      "double",
      "double",
      "double",
      "double",
      "double"),
  OBJECT_X(Type.OBJECT, "getX", double.class, Use.READ),
  OBJECT_Y(Type.OBJECT, "getY", double.class, Use.READ),
  TRACKED_X(Type.OBJECT, "getX", double.class, Use.TRACK, Advices.Place.class),
  TRACKED_Y(Type.OBJECT, "getY", double.class, Use.TRACK, Advices.Place.class),
  FEATURES(Type.OBJECT, "getFeatures", Object.class, Use.NAME);

  /** The classes that have these methods. */
  enum Type {
    CORE("SimCore"),
    CAMERA("CameraController"),
    OBJECT("TraceableObject");

    final String name;

    Type(String shortName) {
      name = "epics.camsim.core." + shortName;
    }
  }

  final Type type;
  final String method;
  final Use use;
  final Class<?> advice;

  @SuppressWarnings("ImmutableEnumChecker") // nothing changes it
  final List<String> parameters;

  private final Class<?> returned;

  CamSimMethod(Type type, String method, Class<?> returned, Use use) {
    this(type, method, returned, use, null);
  }

  /**
   * @param returned the type of the result: {@code void} stands for any type, and {@code Object}
   *     for any but void
   * @param advice the code that is woven into the method, which the class itself then has to
   *     declare; null for a method that is only called
   * @param parameters the full names of the parameters' types
   */
  CamSimMethod(
      Type type, String method, Class<?> returned, Use use, Class<?> advice, String... parameters) {
    this.type = type;
    this.method = method;
    this.returned = returned;
    this.use = use;
    this.advice = advice;
    this.parameters = List.of(parameters);
  }

  /** Whether a method with a result of this type is acceptable. */
  boolean returns(String typeName) {
    return returned == void.class
        || (returned == Object.class
            ? !typeName.equals("void")
            : typeName.equals(returned.getName()));
  }

  /**
   * Returns the type of a handle to the method. Its first parameter is the owner; all types but
   * numbers are objects.
   */
  MethodType handleType() {
    List<Class<?>> types =
        parameters.stream()
            .<Class<?>>map(name -> name.equals("double") ? double.class : Object.class)
            .toList();
    return MethodType.methodType(returned, types).insertParameterTypes(0, Object.class);
  }

  /** Returns the name and types of the method, as messages show them. */
  String signature() {
    return type.name
        + "."
        + method
        + parameters.stream()
            .map(parameter -> parameter.substring(parameter.lastIndexOf('.') + 1))
            .collect(Collectors.joining(", ", "(", ")"))
        + (returned == double.class || returned == boolean.class ? " returning " + returned : "");
  }

  /** Whether a method of this name has these parameters. */
  boolean is(String name, List<String> parameterTypes) {
    return name.equals(method) && parameterTypes.equals(parameters);
  }
}
