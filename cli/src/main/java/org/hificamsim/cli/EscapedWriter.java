package org.hificamsim.cli;

import java.io.FilterWriter;
import java.io.IOException;
import java.io.PrintWriter;
import org.hificamsim.core.Place;

/** Shows control characters and marks of direction in users' names as what they are. */
final class EscapedWriter extends FilterWriter {
  private final PrintWriter terminal;

  EscapedWriter(PrintWriter terminal) {
    super(terminal);
    this.terminal = terminal;
  }

  @Override
  public void write(String text, int from, int length) throws IOException {
    terminal.write(Place.escaped(text.substring(from, from + length), "\\"));
    if (terminal.checkError()) {
      throw new IOException("the terminal cannot be written");
    }
  }

  @Override
  public void write(char[] text, int from, int length) throws IOException {
    write(new String(text, from, length), 0, length);
  }

  @Override
  public void write(int character) throws IOException {
    write(Character.toString(character), 0, 1);
  }
}
