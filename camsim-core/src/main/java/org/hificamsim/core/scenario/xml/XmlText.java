package org.hificamsim.core.scenario.xml;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.Charset;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/**
 * The content of a scenario file, for finding places.
 *
 * <p>The parser reports where a start tag ends; since no attribute can hold {@code <}, the tag
 * begins at the last one before that. Only asked when there is something to report.
 */
final class XmlText {
  private static final Pattern LINE_END = Pattern.compile("\r\n|\r|\n");
  private static final Pattern ATTRIBUTE =
      Pattern.compile("\\s([^\\s=]+)\\s*=\\s*(?:\"[^\"]*\"|'[^']*')");

  private final String file;
  private final byte[] bytes;
  private final Consumer<String> warnings;
  private Charset charset;
  private String text;
  private int[] lines; // where each begins

  /**
   * @param warnings takes one line for each thing that is odd
   */
  XmlText(String file, byte[] bytes, Consumer<String> warnings) {
    this.file = file;
    this.bytes = bytes;
    this.warnings = warnings;
  }

  /** Takes note of the encoding that the parser has found. */
  void encodedIn(String encoding) {
    charset = Charset.forName(encoding);
  }

  /** Reports something odd. */
  void warn(String line) {
    warnings.accept(line);
  }

  /** The first byte that is not in the encoding: the parser reads ahead, and names its block. */
  Optional<InputException> undecodable() {
    ByteBuffer in = ByteBuffer.wrap(bytes);
    CharBuffer out = CharBuffer.allocate(bytes.length);
    boolean wrong = charset.newDecoder().decode(in, out, true).isError();
    text = withoutMark(out.flip().toString());
    String problem = "byte 0x%02X is not %s, expected text in that encoding";
    return wrong
        ? Optional.of(at(text.length()).error(problem, bytes[in.position()], charset.name()))
        : Optional.empty();
  }

  private static String withoutMark(String text) {
    return text.startsWith("\uFEFF") ? text.substring(1) : text;
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
    int[] begins = lines();
    return Math.min(
        begins[Math.min(place.line(), begins.length) - 1] + place.column() - 1, text.length());
  }

  /** The place of a character, from 0; at most the text's length. */
  private Place at(int offset) {
    int found = Arrays.binarySearch(lines(), offset);
    int line = found >= 0 ? found : -found - 2;
    return new Place(file, line + 1, offset - lines()[line] + 1);
  }

  private int[] lines() {
    if (lines == null) {
      text = text == null ? withoutMark(new String(bytes, charset)) : text;
      IntStream ends = LINE_END.matcher(text).results().mapToInt(MatchResult::end);
      lines = IntStream.concat(IntStream.of(0), ends).toArray();
    }
    return lines;
  }
}
