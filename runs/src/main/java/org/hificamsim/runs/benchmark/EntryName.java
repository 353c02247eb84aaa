package org.hificamsim.runs.benchmark;

import java.lang.Character.UnicodeBlock;
import java.lang.Character.UnicodeScript;
import java.text.Normalizer;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;

/** Checks the names of entries, and finds names that look alike. */
final class EntryName {
  private static final int MAX_LENGTH = 80;

  /** Scripts that texts in Latin letters also use: formulas, and names from East Asia. */
  private static final Set<UnicodeScript> WITH_LATIN =
      EnumSet.of(
          UnicodeScript.GREEK,
          UnicodeScript.HAN,
          UnicodeScript.HIRAGANA,
          UnicodeScript.KATAKANA,
          UnicodeScript.HANGUL,
          UnicodeScript.BOPOMOFO);

  /** Blocks of letters for sounds, many of which look like Latin letters. */
  private static final Set<UnicodeBlock> PHONETIC =
      Set.of(
          UnicodeBlock.IPA_EXTENSIONS,
          UnicodeBlock.PHONETIC_EXTENSIONS,
          UnicodeBlock.PHONETIC_EXTENSIONS_SUPPLEMENT);

  /** Letters that are shown as nothing: fillers of Korean and Braille. */
  private static final String FILLERS = "\u115f\u1160\u3164\uffa0\u2800";

  /** Characters that look like the ones at the same index of {@link #LATIN}. */
  private static final String LOOKALIKES =
      "\u0430\u0432\u0435\u043a\u043c\u043d\u043e\u0440\u0441\u0442\u0443\u0445\u0455\u0456\u0458"
          + "\u0501\u051b\u051d\u04bb\u0433\u03b1\u03b5\u03b9\u03ba\u03bd\u03bf\u03c1\u03c4\u03c5"
          + "\u03c7\u03b2\u03b6\u03b7\u03bc\u03b3\u0131i1|0";

  private static final String LATIN = "abekmhopctyxsljdqwhraelkvoptyxbznmyllllo";

  private EntryName() {}

  /** Rejects a name that cannot be shown, or that mixes letters which look like others. */
  static void require(String name) {
    requireVisible("name", name);
    if (name.isBlank() || name.length() > MAX_LENGTH) {
      throw InputException.of(
          "name has %s characters, expected 1 to %s and not only blanks",
          name.length(), MAX_LENGTH);
    }
    if (name.codePoints().mapToObj(UnicodeBlock::of).anyMatch(PHONETIC::contains)) {
      throw new InputException("name has phonetic letters, which look like others, expected none");
    }
    Set<UnicodeScript> scripts = scripts(name);
    if (scripts.remove(UnicodeScript.LATIN)) {
      scripts.removeAll(WITH_LATIN);
      if (!scripts.isEmpty()) {
        throw InputException.of(
            "name has Latin letters and those of %s, which look alike, expected one script",
            scripts.iterator().next());
      }
    }
  }

  private static Set<UnicodeScript> scripts(String name) {
    Set<UnicodeScript> scripts =
        name.codePoints()
            .mapToObj(UnicodeScript::of)
            .collect(Collectors.toCollection(() -> EnumSet.noneOf(UnicodeScript.class)));
    scripts.removeAll(EnumSet.of(UnicodeScript.COMMON, UnicodeScript.INHERITED));
    return scripts;
  }

  /** Rejects a text with characters that are invisible, or that change how others are shown. */
  static void requireVisible(String property, String text) {
    if (text.codePoints().anyMatch(EntryName::isInvisible)) {
      throw InputException.of(
          "%s has an invisible character, such as a line feed, expected none", property);
    }
  }

  private static boolean isInvisible(int character) {
    return switch (Character.getType(character)) {
      case Character.CONTROL,
              Character.FORMAT,
              Character.LINE_SEPARATOR,
              Character.PARAGRAPH_SEPARATOR,
              Character.SURROGATE,
              Character.UNASSIGNED,
              Character.PRIVATE_USE ->
          true;
      default -> FILLERS.indexOf(character) >= 0;
    };
  }

  /**
   * Returns the skeleton of a name, which is equal for names that look alike: it is in lower case,
   * without accents and blanks, and with each letter replaced by the Latin one that it looks like.
   */
  static String skeleton(String name) {
    return Normalizer.normalize(name, Normalizer.Form.NFKD)
        .toLowerCase(Locale.ROOT)
        .codePoints()
        .filter(character -> !isMark(character) && !Character.isWhitespace(character))
        .map(EntryName::latin)
        .mapToObj(Character::toString)
        .collect(Collectors.joining());
  }

  private static boolean isMark(int character) {
    int type = Character.getType(character);
    return type == Character.NON_SPACING_MARK || type == Character.ENCLOSING_MARK;
  }

  private static int latin(int character) {
    if (Character.getType(character) == Character.DASH_PUNCTUATION) {
      return '-';
    }
    int index = LOOKALIKES.indexOf(character);
    return index < 0 ? character : LATIN.charAt(index);
  }
}
