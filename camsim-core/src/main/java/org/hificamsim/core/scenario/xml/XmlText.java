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
 * Finds places in the text of a scenario file, for messages.
 *
 * <p>The parser reports where a start tag ends. Since no attribute can contain {@code <}, the tag
 * begins at the last one before that.
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
  private int[] lineStarts;

  /**
   * @param warnings receives one line for each warning
   */
  XmlText(String file, byte[] bytes, Consumer<String> warnings) {
    this.file = file;
    this.bytes = bytes;
    this.warnings = warnings;
  }

  /** Sets the encoding that the parser has found. */
  void setEncoding(String encoding) {
    charset = Charset.forName(encoding);
  }

  /** Reports a warning. */
  void warn(String line) {
    warnings.accept(line);
  }

  /**
   * The error about the first byte that is invalid in the encoding; the parser names only its
   * block.
   */
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

  /** The place where a tag begins that ends at a place. */
  Place tag(Place end) {
    return at(start(offset(end)));
  }

  /** The place of an attribute in the tag that ends at a place; the place of the tag without it. */
  Place attribute(Place end, String name) {
    int start = start(offset(end));
    Matcher attribute = ATTRIBUTE.matcher(text).region(start, offset(end));
    return attribute
        .results()
        .filter(found -> found.group(1).equals(name))
        .findFirst()
        .map(found -> at(found.start(1)))
        .orElseGet(() -> at(start));
  }

  private int start(int end) {
    return Math.max(0, text.lastIndexOf('<', end - 1));
  }

  private int offset(Place place) {
    int[] begins = lineStarts();
    return Math.min(
        begins[Math.min(place.line(), begins.length) - 1] + place.column() - 1, text.length());
  }

  /** The place of an offset in the text. */
  private Place at(int offset) {
    int found = Arrays.binarySearch(lineStarts(), offset);
    int line = found >= 0 ? found : -found - 2;
    return new Place(file, line + 1, offset - lineStarts()[line] + 1);
  }

  private int[] lineStarts() {
    if (lineStarts == null) {
      text = text == null ? withoutMark(new String(bytes, charset)) : text;
      IntStream ends = LINE_END.matcher(text).results().mapToInt(MatchResult::end);
      lineStarts = IntStream.concat(IntStream.of(0), ends).toArray();
    }
    return lineStarts;
  }
}
