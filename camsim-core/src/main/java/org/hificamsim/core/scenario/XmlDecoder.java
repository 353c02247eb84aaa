package org.hificamsim.core.scenario;

import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.Charset;
import java.nio.charset.CharsetDecoder;
import java.nio.charset.CoderResult;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Texts;

/**
 * Turns the bytes of an XML file into text, in the encoding that the file declares, else UTF-16
 * where its first bytes show that, else UTF-8.
 *
 * <p>The parser could do so too, but reads in blocks and places faults at a block's end.
 */
final class XmlDecoder {
  private static final Pattern DECLARED =
      Pattern.compile("\\A<\\?xml\\s[^>]*?\\s(encoding\\s*=\\s*([\"'])(.*?)\\2)", Pattern.DOTALL);
  private static final Pattern BYTE_ORDER_MARK = Pattern.compile("\\A(ï»¿|þÿ|ÿþ|\uFEFF)");
  private static final int MAX_DECLARATION = 400;

  private final String file;
  private final byte[] bytes;

  private XmlDecoder(String file, byte[] bytes) {
    this.file = file;
    this.bytes = bytes;
  }

  /**
   * The text, without a byte order mark.
   *
   * @throws InputException when the encoding is unknown or the bytes are not in it
   */
  static String decode(String file, byte[] bytes) {
    return new XmlDecoder(file, bytes).text();
  }

  private String text() {
    String head = start(StandardCharsets.ISO_8859_1).replace("\0", "");
    Matcher declaration = DECLARED.matcher(head);
    Charset charset = declaration.find() ? declared(head, declaration) : detected();
    CharsetDecoder decoder = charset.newDecoder().onMalformedInput(CodingErrorAction.REPORT);
    ByteBuffer in = ByteBuffer.wrap(bytes);
    CharBuffer out = CharBuffer.allocate((int) (bytes.length * (double) decoder.maxCharsPerByte()));
    CoderResult result = decoder.decode(in, out, true);
    String text = withoutMark(out.flip().toString());
    if (result.isError()) {
      throw new XmlText(file, text)
          .at(text.length())
          .error(
              Texts.format(
                  "byte 0x%02X is not %s, expected text in that encoding",
                  bytes[in.position()], charset.name()));
    }
    return text;
  }

  private Charset declared(String head, Matcher declaration) {
    String name = declaration.group(3);
    Charset charset = find(name);
    if (charset == null || !start(charset).startsWith("<?xml")) {
      throw new XmlText(file, head)
          .at(declaration.start(1))
          .invalid(
              "the encoding",
              name,
              charset == null
                  ? "UTF-8 or another one that is known"
                  : "the one that the file is in");
    }
    return charset;
  }

  private static Charset find(String name) {
    try {
      return Charset.forName(name);
    } catch (IllegalArgumentException e) {
      return null;
    }
  }

  private Charset detected() {
    int first = bytes.length < 2 ? 0 : (bytes[0] & 0xff) << 8 | (bytes[1] & 0xff);
    return switch (first) {
      case 0xfffe, '<' << 8 -> StandardCharsets.UTF_16LE;
      case 0xfeff, '<' -> StandardCharsets.UTF_16BE;
      default -> StandardCharsets.UTF_8;
    };
  }

  private String start(Charset charset) {
    return withoutMark(new String(bytes, 0, Math.min(bytes.length, MAX_DECLARATION), charset));
  }

  private static String withoutMark(String text) {
    Matcher mark = BYTE_ORDER_MARK.matcher(text);
    return mark.lookingAt() ? text.substring(mark.end()) : text;
  }
}
