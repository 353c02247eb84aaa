package org.hificamsim.acceptance;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A change to a valid text.
 *
 * @param at the place, as a share of the text, in [0, 1)
 * @param length the number of changed characters, from 1 to 40
 * @param piece the text that insertions and replacements use
 */
record FuzzEdit(Kind kind, double at, int length, String piece) {
  private static final Pattern NUMBER = Pattern.compile("-?\\d+(\\.\\d+)?");
  private static final Pattern WORD = Pattern.compile("[A-Za-z_]+");
  private static final int LONGEST = 40;

  private static final List<String> PIECES =
      List.of(
          "",
          "0",
          "-1",
          "-0.0",
          "NaN",
          "Infinity",
          "1e999",
          "-1e308",
          "4.9e-324",
          "1e9",
          "0x10",
          "99999999999999999999",
          "2147483648",
          "\u0000",
          "\u001b[2J",
          "\u2028",
          "\u00e9",
          "\ufeff",
          "<",
          "<a>",
          "</root>",
          "<!--",
          "]]>",
          "&amp;",
          "&x;",
          "<zoom>",
          "<camera/>",
          "<!DOCTYPE a>",
          "\"",
          "'",
          "=",
          ",",
          ",,",
          ":",
          "@",
          ";",
          "\n",
          "\r\n",
          " ",
          "{",
          "}",
          "[",
          "]",
          "[[1]]",
          "null",
          "true",
          "\\u0000",
          "--seed",
          "--json",
          "--strict",
          "--record",
          "--quiet",
          "--help",
          "--threshold",
          "a=b",
          "x".repeat(9999));

  /** The ways of breaking a text. */
  enum Kind {
    DELETE,
    REPEAT,
    INSERT,
    NUMBER,
    WORD,
    FLIP,
    CUT
  }

  /** Returns a random change. */
  static FuzzEdit of(Random random) {
    Kind[] kinds = Kind.values();
    String piece = PIECES.get(random.nextInt(PIECES.size()));
    return new FuzzEdit(
        kinds[random.nextInt(kinds.length)],
        random.nextDouble(),
        1 + random.nextInt(LONGEST),
        new String(piece.getBytes(StandardCharsets.UTF_8), StandardCharsets.ISO_8859_1));
  }

  /** Returns a change of one bit at the same place. */
  FuzzEdit flip() {
    return new FuzzEdit(Kind.FLIP, at, length, piece);
  }

  /** Returns the changed text. */
  String apply(String text) {
    int from = (int) (at * text.length());
    int to = Math.min(text.length(), from + length);
    String start = text.substring(0, from);
    String middle = text.substring(from, to);
    String end = text.substring(to);
    return switch (kind) {
      case DELETE -> start + end;
      case REPEAT -> start + middle.repeat(1 + length) + end;
      case INSERT -> start + piece + middle + end;
      case NUMBER -> replaced(NUMBER, text, from);
      case WORD -> replaced(WORD, text, from);
      case FLIP -> start + flipped(middle) + end;
      case CUT -> start;
    };
  }

  private String replaced(Pattern pattern, String text, int from) {
    Matcher found = pattern.matcher(text);
    return found.find(from)
        ? text.substring(0, found.start()) + piece + text.substring(found.end())
        : text;
  }

  private String flipped(String text) {
    return text.isEmpty()
        ? text
        : (char) (text.charAt(0) ^ (1 << (length % 8))) + text.substring(1);
  }
}
