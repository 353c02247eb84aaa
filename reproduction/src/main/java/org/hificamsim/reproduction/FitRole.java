package org.hificamsim.reproduction;

import java.util.Locale;

/** Whether our defaults were fitted to a published result, or are tested by it. */
public enum FitRole {
  /** The hi-fi column of Table 8.1 and what follows from it: agreement shows consistency only. */
  FITTED,
  /** All other results, for which no default was chosen. */
  HELD_OUT;

  /** The name in files. */
  public String label() {
    return name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }
}
