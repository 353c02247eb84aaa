package org.hificamsim.tracks.place;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;
import org.hificamsim.tracks.place.DrawnPart.Traits;

/** Reads a file of geometries in well-known text, one after the other. */
final class WktWalls {
  /** The greatest number of characters before the coordinates of a geometry. */
  private static final int MAX_HEAD = 200;

  /** The greatest number of characters of a geometry. */
  private static final int MAX_TEXT = 500_000_000;

  private static final String EMPTY = "EMPTY";

  private final WktShapes shapes;
  private final StringBuilder text = new StringBuilder();
  private int line = 1;
  private int firstLine;

  WktWalls(WktShapes shapes) {
    this.shapes = shapes;
  }

  void read(Path file) {
    try (Reader in =
        new BufferedReader(new InputStreamReader(TextLines.stream(file), StandardCharsets.UTF_8))) {
      while (readGeometry(in)) {
        shapes.add(new Place(file.toString(), firstLine, 1), text.toString(), Traits.NONE);
      }
    } catch (IOException e) {
      throw TextLines.unreadable(file.toString(), 1, e);
    }
  }

  /** Reads the text up to the last bracket of a geometry; returns false at the end of the file. */
  private boolean readGeometry(Reader in) throws IOException {
    text.setLength(0);
    int depth = 0;
    boolean isWhole = false;
    while (!isWhole) {
      int next = in.read();
      if (next < 0) {
        break;
      }
      boolean isSpace = Character.isWhitespace(next) || next == 0xfeff;
      if (!isSpace || !text.isEmpty()) {
        firstLine = text.isEmpty() ? line : firstLine;
        text.append((char) next);
      }
      line += next == '\n' ? 1 : 0;
      depth += next == '(' ? 1 : next == ')' ? -1 : 0;
      boolean isClosed = next == ')' && depth <= 0;
      isWhole = isClosed || text.length() > MAX_TEXT;
      isWhole |= depth == 0 && isWholeWithoutBrackets(isSpace);
    }
    return !text.isEmpty();
  }

  private boolean isWholeWithoutBrackets(boolean endsInSpace) {
    int end = text.length() - 1;
    return text.length() > MAX_HEAD
        || (endsInSpace
            && end >= EMPTY.length()
            && text.substring(end - EMPTY.length(), end).equalsIgnoreCase(EMPTY));
  }
}
