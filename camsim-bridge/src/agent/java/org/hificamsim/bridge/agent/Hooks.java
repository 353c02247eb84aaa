package org.hificamsim.bridge.agent;

/**
 * Passes the calls that are woven into CamSim's classes to the one {@link Bridge} of this JVM,
 * whose class CamSim does not see.
 */
public final class Hooks {
  private static volatile Bridge bridge;

  private Hooks() {}

  /** Sets the bridge, before the first of CamSim's classes is woven. */
  public static void connect(Bridge newBridge) {
    bridge = newBridge;
  }

  /** See {@link Bridge#stepBegins}. */
  public static void stepBegins(Object core) {
    bridge.stepBegins(core);
  }

  /** See {@link Bridge#stepEnds}. */
  public static void stepEnds(Object core) {
    bridge.stepEnds(core);
  }

  /** See {@link Bridge#runEnds}. */
  public static void runEnds(Object core) {
    bridge.runEnds(core);
  }

  /** See {@link Bridge#look}. */
  public static double look(Object camera, Object object) {
    return bridge.look(camera, object);
  }

  /** See {@link Bridge#looked}. */
  public static void looked(Object camera, Object object, double confidence) {
    bridge.looked(camera, object, confidence);
  }

  /** See {@link Bridge#coordinate}. */
  public static double coordinate(Object object, boolean isY, double camSimValue) {
    return bridge.coordinate(object, isY, camSimValue);
  }
}
