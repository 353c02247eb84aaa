package org.hificamsim.core;

import java.util.Locale;

/** Formats texts independently of the locale. */
public final class Texts {
  private Texts() {}

  /** Formats like {@link String#format}, in the root locale. */
  public static String format(String form, Object... values) {
    return String.format(Locale.ROOT, form, values);
  }

  /** Formats a number of things, such as "1 photo" and "2 photos". */
  public static String counted(long count, String thing) {
    return count + " " + thing + (count == 1 ? "" : thing.endsWith("s") ? "es" : "s");
  }
}
