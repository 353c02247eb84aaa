package org.hificamsim.bridge.camsim;

import net.bytebuddy.asm.Advice;
import org.hificamsim.bridge.agent.Hooks;

/** Woven into {@code TraceableObject.getX()}. */
final class PlaceXAdvice {
  private PlaceXAdvice() {}

  @Advice.OnMethodExit
  @SuppressWarnings({"ParameterReassign", "UnusedVariable"}) // assigning sets what is returned
  static void exit(@Advice.This Object object, @Advice.Return(readOnly = false) double returned) {
    returned = Hooks.place(object, false, returned);
  }
}
