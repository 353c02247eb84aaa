package org.hificamsim.core;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The name of a setting within the message of an {@link InputException}.
 *
 * <p>A library does not know how its users choose a setting: the command line takes {@code --steps
 * 100}, Python {@code steps=100}. It therefore marks the name, and the front end writes it in its
 * own {@link Notation}:
 *
 * <pre>{@code
 * throw InputException.of("%s is %s, expected 1 or more", setting("steps"), steps);
 * }</pre>
 */
public final class NamedSetting {
  /** The setting's plain name, and {@code name=value} where the message also has a value. */
  public static final Notation PLAIN =
      new Notation() {
        @Override
        public String name(String setting) {
          return setting;
        }

        @Override
        public String assignment(String setting, String value) {
          return setting + "=" + value;
        }
      };

  /** The notation that keeps the marks, for a message that becomes part of another one. */
  public static final Notation MARKED =
      new Notation() {
        @Override
        public String name(String setting) {
          return setting(setting);
        }

        @Override
        public String assignment(String setting, String value) {
          return setting(setting, value);
        }
      };

  /**
   * A mark made of one of Unicode's noncharacters, which texts exchanged between programs must not
   * contain.
   */
  private static final char BEGIN = '\uFDD0';

  private static final char EQUALS = '\uFDD1';
  private static final char END = '\uFDD2';

  private static final Pattern MARK =
      Pattern.compile(
          BEGIN + "([^" + EQUALS + END + "]*)(?:" + EQUALS + "([^" + END + "]*))?" + END);

  /** Writes the names of settings as the users of a front end know them. */
  public interface Notation {
    /** A setting, such as {@code --steps} for {@code steps}. */
    String name(String setting);

    /** A setting with a value, such as {@code --steps 100}. */
    String assignment(String setting, String value);
  }

  private NamedSetting() {}

  /**
   * A setting's name for a message.
   *
   * @param name the name as files and Python write it, with {@code _} between words
   */
  public static String setting(String name) {
    return BEGIN + name + END;
  }

  /** A setting's name with a value, for a message. */
  public static String setting(String name, String value) {
    return BEGIN + name + EQUALS + value + END;
  }

  /** A message with the settings that it names in a front end's notation. */
  public static String written(String message, Notation notation) {
    return MARK.matcher(message)
        .replaceAll(
            marked ->
                Matcher.quoteReplacement(written(marked.group(1), marked.group(2), notation)));
  }

  private static String written(String name, String value, Notation notation) {
    return value == null ? notation.name(name) : notation.assignment(name, value);
  }
}
