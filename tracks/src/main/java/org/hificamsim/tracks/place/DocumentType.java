package org.hificamsim.tracks.place;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.PushbackReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;

/**
 * Checks that a document type ends within its file. Otherwise the JDK's parser prints a stack trace
 * of its own.
 */
final class DocumentType {
  private static final int LONGEST = "<!DOCTYPE".length();

  private final PushbackReader in;
  private int last; // the character that was read last, -1 at the end

  private DocumentType(PushbackReader in) {
    this.in = in;
  }

  /**
   * Refuses a file whose document type does not end.
   *
   * @throws org.hificamsim.core.InputException if it does not, or the file cannot be read
   */
  static void requireEnd(Path file) {
    try (InputStream bytes = TextLines.stream(file)) {
      DocumentType type =
          new DocumentType(
              new PushbackReader(
                  new InputStreamReader(bytes, StandardCharsets.ISO_8859_1), LONGEST));
      if (!type.ends()) {
        throw new Place(file.toString(), 1, 1)
            .error("the document type is cut off, expected a whole file");
      }
    } catch (IOException e) {
      throw TextLines.unreadable(file.toString(), 1, e);
    }
  }

  /** Whether the document type ends; true if there is none. */
  private boolean ends() throws IOException {
    while (next() >= 0) {
      if (last == '<' && !skip("!--", "-->") && !skip("?", "?>")) {
        return !starts("!DOCTYPE") || skipType();
      }
    }
    return true;
  }

  /** Skips a document type to its end; returns false if there is none. */
  private boolean skipType() throws IOException {
    boolean isInside = false;
    while (next() >= 0) {
      if (last == '"' || last == '\'') {
        skipTo(String.valueOf((char) last));
      } else if (last == '<' && !skip("!--", "-->")) {
        skip("?", "?>");
      } else if (last == '[' || last == ']') {
        isInside = last == '[';
      } else if (last == '>' && !isInside) {
        return true;
      }
    }
    return false;
  }

  private int next() throws IOException {
    last = in.read();
    return last;
  }

  /** Skips what begins with a text and ends with another; returns false if it does not begin so. */
  private boolean skip(String begin, String end) throws IOException {
    if (!starts(begin)) {
      return false;
    }
    skipTo(end);
    return true;
  }

  private boolean starts(String text) throws IOException {
    for (int i = 0; i < text.length(); i++) {
      int read = in.read();
      if (read != text.charAt(i)) {
        if (read >= 0) {
          in.unread(read);
        }
        in.unread(text.toCharArray(), 0, i);
        return false;
      }
    }
    return true;
  }

  private void skipTo(String end) throws IOException {
    int matched = 0;
    while (matched < end.length() && next() >= 0) {
      boolean repeats = last == end.charAt(0);
      matched = last == end.charAt(matched) ? matched + 1 : repeats ? Math.max(1, matched) : 0;
    }
  }
}
