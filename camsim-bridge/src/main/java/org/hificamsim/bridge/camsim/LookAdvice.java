package org.hificamsim.bridge.camsim;

import net.bytebuddy.asm.Advice;
import org.hificamsim.bridge.agent.Hooks;

/**
 * Woven into {@code CameraController.update_visiblity(TraceableObject)}: CamSim's own code runs
 * only where the bridge does not look in its place.
 */
final class LookAdvice {
  private LookAdvice() {}

  @Advice.OnMethodEnter(skipOn = Advice.OnNonDefaultValue.class)
  static boolean enter(
      @Advice.This Object camera,
      @Advice.Argument(0) Object object,
      @Advice.Local("confidence") double confidence) {
    confidence = Hooks.look(camera, object);
    return !Double.isNaN(confidence);
  }

  @Advice.OnMethodExit
  @SuppressWarnings({"ParameterReassign", "UnusedVariable"}) // assigning sets what is returned
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
