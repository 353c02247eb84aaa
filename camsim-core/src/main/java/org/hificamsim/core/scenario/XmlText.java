package org.hificamsim.core.scenario;

import java.io.StringReader;
import java.util.Arrays;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;

/**
 * The characters of a scenario file, for finding places.
 *
 * <p>The parser reports where a start tag ends; since no attribute can hold {@code <}, the tag
 * begins at the last one before that. Only asked when there is something to report.
 */
final class XmlText {
  private final String file;
  private final String text;
  private int[] lines;

  XmlText(String file, String text) {
    this.file = file;
    this.text = text;
  }

  /** A value as error lines quote it: on one line, and not too long. */
  static String shortened(String value, int max) {
    String flat = value.substring(0, Math.min(value.length(), max + 1)).replaceAll("\\s+", " ");
    return value.length() > max ? flat.substring(0, Math.min(flat.length(), max)) + "..." : flat;
  }

  /** The lines of a part of the file that begins in this one, from 1. */
  TextLines lines(String part, int firstLine) {
    return new TextLines(file, new StringReader(part), firstLine);
  }

  Place tag(int endLine, int endColumn) {
    return at(tagStart(endLine, endColumn));
  }

  Place attribute(int endLine, int endColumn, String name) {
    int start = tagStart(endLine, endColumn);
    char quote = 0;
    for (int i = start; i < text.length(); i++) {
      char c = text.charAt(i);
      if (quote != 0) {
        quote = c == quote ? 0 : quote;
      } else if (c == '"' || c == '\'') {
        quote = c;
      } else if (c == '>') {
        break;
      } else if (Character.isWhitespace(c) && startsAttribute(i + 1, name)) {
        return at(i + 1);
      }
    }
    return at(start);
  }

  private boolean startsAttribute(int at, String name) {
    if (!text.startsWith(name, at)) {
      return false;
    }
    int i = at + name.length();
    while (i < text.length() && Character.isWhitespace(text.charAt(i))) {
      i++;
    }
    return i < text.length() && text.charAt(i) == '=';
  }

  private int tagStart(int endLine, int endColumn) {
    int line = Math.min(endLine, lines().length) - 1;
    return Math.max(0, text.lastIndexOf('<', Math.max(0, lines()[line] + endColumn - 2)));
  }

  /** The place of a character, from 0; at most the text's length. */
  Place at(int offset) {
    int found = Arrays.binarySearch(lines(), offset);
    int line = found >= 0 ? found : -found - 2;
    return new Place(file, line + 1, offset - lines()[line] + 1);
  }

  /** Where each line starts. */
  private int[] lines() {
    if (lines == null) {
      int[] starts = new int[16];
      int count = 1;
      for (int i = 0; i < text.length(); i++) {
        if (endsLine(i)) {
          starts = count == starts.length ? Arrays.copyOf(starts, 2 * count) : starts;
          starts[count++] = i + 1;
        }
      }
      lines = Arrays.copyOf(starts, count);
    }
    return lines;
  }

  private boolean endsLine(int i) {
    char c = text.charAt(i);
    return c == '\n' || (c == '\r' && (i + 1 == text.length() || text.charAt(i + 1) != '\n'));
  }
}
