package org.hificamsim.reproduction;

import java.util.Locale;

/** Whether the defaults were chosen for something, or have to stand up to it. */
public enum FitRole {
  /** The hi-fi column of Table 8.1, and what it says by itself: agreeing shows consistency. */
  FITTED,
  /** Everything else, which no default was chosen for. */
  HELD_OUT;

  /** The name in files. */
  public String label() {
    return name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }
}
