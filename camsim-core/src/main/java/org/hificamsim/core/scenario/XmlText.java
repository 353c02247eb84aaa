package org.hificamsim.core.scenario;

import java.io.StringReader;
import java.util.Arrays;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;

/**
 * The characters of a scenario file, for finding places.
 *
 * <p>The parser reports where a start tag ends; since no attribute can hold {@code <}, the tag
 * begins at the last one before that. Only asked when there is something to report.
 */
final class XmlText {
  private static final Pattern LINE_END = Pattern.compile("\r\n|\r|\n");
  private static final Pattern ATTRIBUTE =
      Pattern.compile("\\s([^\\s=]+)\\s*=\\s*(?:\"[^\"]*\"|'[^']*')");

  private final String file;
  private final String text;
  private int[] lines; // where each begins

  XmlText(String file, String text) {
    this.file = file;
    this.text = text;
  }

  /** The lines of a part of the file that begins in one of its lines, from 1. */
  TextLines lines(String part, int firstLine) {
    return new TextLines(file, new StringReader(part), firstLine);
  }

  /** Where a tag begins that ends at a place. */
  Place tag(Place end) {
    return at(start(offset(end)));
  }

  /** Where an attribute begins of a tag that ends at a place; without such a one, the tag. */
  Place attribute(Place end, String name) {
    int start = start(offset(end));
    Matcher attribute = ATTRIBUTE.matcher(text).region(start, offset(end));
    return attribute
        .results()
        .filter(one -> one.group(1).equals(name))
        .findFirst()
        .map(one -> at(one.start(1)))
        .orElseGet(() -> at(start));
  }

  private int start(int end) {
    return Math.max(0, text.lastIndexOf('<', end - 1));
  }

  private int offset(Place place) {
    return Math.min(
        lines()[Math.min(place.line(), lines().length) - 1] + place.column() - 1, text.length());
  }

  /** The place of a character, from 0; at most the text's length. */
  Place at(int offset) {
    int found = Arrays.binarySearch(lines(), offset);
    int line = found >= 0 ? found : -found - 2;
    return new Place(file, line + 1, offset - lines()[line] + 1);
  }

  private int[] lines() {
    if (lines == null) {
      IntStream ends = LINE_END.matcher(text).results().mapToInt(MatchResult::end);
      lines = IntStream.concat(IntStream.of(0), ends).toArray();
    }
    return lines;
  }
}
