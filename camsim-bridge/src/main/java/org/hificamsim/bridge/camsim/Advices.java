package org.hificamsim.bridge.camsim;

import net.bytebuddy.asm.Advice;
import org.hificamsim.bridge.agent.Hooks;

/** The pieces of code that are woven into CamSim's methods; each calls a hook. */
final class Advices {
  private Advices() {}

  /** Woven into {@code SimCore.update()}. A step that throws an exception does not end. */
  static final class Step {
    private Step() {}

    @Advice.OnMethodEnter
    static void enter(@Advice.This Object core) {
      Hooks.stepBegins(core);
    }

    @Advice.OnMethodExit
    static void exit(@Advice.This Object core) {
      Hooks.stepEnds(core);
    }
  }

  /** Woven into {@code SimCore.close_files()}. */
  static final class End {
    private End() {}

    @Advice.OnMethodExit
    static void exit(@Advice.This Object core) {
      Hooks.runEnds(core);
    }
  }

  /**
   * Woven into {@code CameraController.update_visiblity(TraceableObject)}. CamSim's own code runs
   * only if the bridge does not look in its place.
   */
  static final class Look {
    private Look() {}

    @Advice.OnMethodEnter(skipOn = Advice.OnNonDefaultValue.class)
    static boolean enter(
        @Advice.This Object camera,
        @Advice.Argument(0) Object object,
        @Advice.Local("confidence") double confidence) {
      confidence = Hooks.look(camera, object);
      return !Double.isNaN(confidence);
    }

    @Advice.OnMethodExit
    @SuppressWarnings({
      "ParameterReassign",
      "UnusedVariable"
    }) // The assignment sets the returned value.
    static void exit(
        @Advice.Enter boolean looked,
        @Advice.This Object camera,
        @Advice.Argument(0) Object object,
        @Advice.Local("confidence") double confidence,
        @Advice.Return(readOnly = false) double returned) {
      if (looked) {
        returned = confidence;
      } else {
        Hooks.looked(camera, object, returned);
      }
    }
  }

  /** Woven into {@code TraceableObject.getX()} and {@code getY()}. */
  static final class Place {
    private Place() {}

    @Advice.OnMethodExit
    @SuppressWarnings({
      "ParameterReassign",
      "UnusedVariable"
    }) // The assignment sets the returned value.
    static void exit(
        @Advice.This Object object,
        @Advice.Origin("#m") String method,
        @Advice.Return(readOnly = false) double returned) {
      returned = Hooks.coordinate(object, method.equals("getY"), returned);
    }
  }
}
