package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import org.hificamsim.core.Place;

/** Escapes control characters and marks of text direction, which users' names may contain. */
final class EscapedWriter extends Writer {
  private final PrintWriter terminal;

  EscapedWriter(PrintWriter terminal) {
    this.terminal = terminal;
  }

  @Override
  public void write(char[] text, int from, int length) throws IOException {
    terminal.write(Place.escaped(new String(text, from, length), "\\"));
    if (terminal.checkError()) {
      throw new IOException("the terminal cannot be written");
    }
  }

  @Override
  public void flush() {
    terminal.flush();
  }

  @Override
  public void close() {
    terminal.close();
  }
}
