package org.hificamsim.core.scenario;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;

/**
 * The characters of a scenario file, for finding places.
 *
 * <p>The parser tells where a start tag ends; since no attribute can hold {@code <}, the tag begins
 * at the last one before that. Only asked when there is something to report.
 */
final class XmlText {
  private final String file;
  private final byte[] bytes;
  private Charset charset = StandardCharsets.UTF_8;
  private String text;

  XmlText(String file, byte[] bytes) {
    this.file = file;
    this.bytes = bytes;
  }

  /** The encoding that the parser found. */
  void encoding(String encoding) {
    if (encoding != null && Charset.isSupported(encoding)) {
      charset = Charset.forName(encoding);
    }
  }

  Place tag(int endLine, int endColumn) {
    return at(tagStart(endLine, endColumn));
  }

  Place attribute(int endLine, int endColumn, String name) {
    int start = tagStart(endLine, endColumn);
    char quote = 0;
    for (int i = start; i < text().length(); i++) {
      char c = text().charAt(i);
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
    if (!text().startsWith(name, at)) {
      return false;
    }
    String rest = text().substring(at + name.length(), Math.min(text().length(), at + 80));
    return rest.stripLeading().startsWith("=");
  }

  private int tagStart(int endLine, int endColumn) {
    int end = 0;
    for (int line = 1; line < endLine; line++) {
      end = nextLine(end);
    }
    return Math.max(0, text().lastIndexOf('<', Math.max(0, end + endColumn - 2)));
  }

  private int nextLine(int from) {
    for (int i = from; i < text().length(); i++) {
      char c = text().charAt(i);
      if (c == '\n' || (c == '\r' && (i + 1 == text().length() || text().charAt(i + 1) != '\n'))) {
        return i + 1;
      }
    }
    return text().length();
  }

  private Place at(int offset) {
    int line = 1;
    int start = 0;
    for (int next = nextLine(0); next <= offset && next > start; next = nextLine(next)) {
      line++;
      start = next;
    }
    return new Place(file, line, offset - start + 1);
  }

  private String text() {
    if (text == null) {
      text = new String(bytes, charset);
      if (text.startsWith("\uFEFF")) {
        text = text.substring(1);
      }
    }
    return text;
  }
}
