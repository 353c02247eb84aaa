package org.hificamsim.solver;

/**
 * Improves a choice by exchange (coordinate ascent): each chooser in turn, such as a camera, takes
 * what is best given the choices of all others, pass after pass.
 */
public final class Exchange {
  /** The choice that is improved. */
  public interface Choice {
    /** The number of choosers in the pass that begins. */
    int choosers();

    /** Gives a chooser what is best for it; returns whether that improved the choice. */
    boolean exchange(int chooser);

    /** Ends a pass; returns whether another one is wanted, as by default after an improvement. */
    default boolean endPass(boolean improved) {
      return improved;
    }
  }

  /** For searches that end by themselves, because each pass must improve the choice. */
  public static final int UNLIMITED = Integer.MAX_VALUE;

  private Exchange() {}

  /** Makes passes over all choosers until none is wanted any more. */
  public static void improve(Choice choice, int maxPasses) {
    boolean wanted = true;
    for (int pass = 0; wanted && pass < maxPasses; pass++) {
      boolean improved = false;
      int choosers = choice.choosers();
      for (int chooser = 0; chooser < choosers; chooser++) {
        improved |= choice.exchange(chooser);
      }
      wanted = choice.endPass(improved);
    }
  }
}
