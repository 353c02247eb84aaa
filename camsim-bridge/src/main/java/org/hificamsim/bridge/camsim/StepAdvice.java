package org.hificamsim.bridge.camsim;

import net.bytebuddy.asm.Advice;
import org.hificamsim.bridge.agent.Hooks;

/** Woven into {@code SimCore.update()}. A step that ends by an exception is not reported. */
final class StepAdvice {
  private StepAdvice() {}

  @Advice.OnMethodEnter
  static void enter(@Advice.This Object core) {
    Hooks.stepBegins(core);
  }

  @Advice.OnMethodExit
  static void exit(@Advice.This Object core) {
    Hooks.stepEnds(core);
  }
}
