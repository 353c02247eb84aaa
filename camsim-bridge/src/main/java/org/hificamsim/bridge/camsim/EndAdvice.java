package org.hificamsim.bridge.camsim;

import net.bytebuddy.asm.Advice;
import org.hificamsim.bridge.agent.Hooks;

/** Woven into {@code SimCore.close_files()}. */
final class EndAdvice {
  private EndAdvice() {}

  @Advice.OnMethodExit
  static void exit(@Advice.This Object core) {
    Hooks.runEnds(core);
  }
}
