package org.hificamsim.core;

import java.util.Locale;

/** Texts with values in them, the same in every country. */
public final class Texts {
  private Texts() {}

  /** A text in the form of {@link String#format}, with numbers as no locale has them. */
  public static String format(String form, Object... values) {
    return String.format(Locale.ROOT, form, values);
  }

  /** A number of things: "1 photo", "2 photos". */
  public static String counted(long count, String thing) {
    return count + " " + thing + (count == 1 ? "" : thing.endsWith("s") ? "es" : "s");
  }
}
