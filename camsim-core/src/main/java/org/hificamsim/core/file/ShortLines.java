package org.hificamsim.core.file;

import java.io.FilterReader;
import java.io.IOException;
import java.io.Reader;

/** Lets no line through that would not fit into the memory, as in a file that is no text. */
final class ShortLines extends FilterReader {
  /** Characters; no line of numbers comes near it. */
  static final int MAX = 1 << 20;

  private int length;

  ShortLines(Reader in) {
    super(in);
  }

  @Override
  public int read(char[] buffer, int start, int most) throws IOException {
    int count = super.read(buffer, start, most);
    for (int i = start; i < start + count; i++) {
      length = buffer[i] == '\n' || buffer[i] == '\r' ? 0 : length + 1;
    }
    if (length > MAX) {
      throw new IOException("a line has more than " + MAX + " characters");
    }
    return count;
  }
}
