package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;
import org.hificamsim.core.Place;

/** Shows control characters and marks of direction in users' names as what they are. */
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
