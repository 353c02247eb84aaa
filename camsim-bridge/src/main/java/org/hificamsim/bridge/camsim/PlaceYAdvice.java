package org.hificamsim.bridge.camsim;

import net.bytebuddy.asm.Advice;
import org.hificamsim.bridge.agent.Hooks;

/** Woven into {@code TraceableObject.getY()}. */
final class PlaceYAdvice {
  private PlaceYAdvice() {}

  @Advice.OnMethodExit
  @SuppressWarnings({"ParameterReassign", "UnusedVariable"}) // assigning sets what is returned
  static void exit(@Advice.This Object object, @Advice.Return(readOnly = false) double returned) {
    returned = Hooks.place(object, true, returned);
  }
}
