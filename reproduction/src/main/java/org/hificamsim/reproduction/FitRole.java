package org.hificamsim.reproduction;

import java.util.Locale;
import java.util.Set;

/** Whether the defaults were chosen for something, or have to stand up to it. */
public enum FitRole {
  /** The hi-fi column of Table 8.1, and what it says by itself: agreeing shows consistency. */
  FITTED,
  /** Everything else, which no default was chosen for. */
  HELD_OUT;

  /** Statements that Table 8.1's hi-fi column implies, at least in part, by their ids. */
  private static final Set<String> IMPLIED =
      Set.of(
          "baselines-below-greedy",
          "order-of-policies",
          "epsilon-greedy-above-zoom-out",
          "learning-pays",
          "zoom-out-not-optimal",
          "camsim-underestimates");

  /** The name in files. */
  public String label() {
    return name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  /** The role of a cell. */
  public static FitRole of(Table81.Cell cell) {
    return cell.published().hifi() ? FITTED : HELD_OUT;
  }

  /** The role of a statement. */
  public static FitRole of(Statement statement) {
    return IMPLIED.contains(statement.id()) ? FITTED : HELD_OUT;
  }
}
