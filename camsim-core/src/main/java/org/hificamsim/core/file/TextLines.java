package org.hificamsim.core.file;

import java.io.BufferedInputStream;
import java.io.BufferedReader;
import java.io.Closeable;
import java.io.FilterReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.StringTokenizer;
import java.util.zip.GZIPInputStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/**
 * Reads the lines of a text file (UTF-8; decompressed if its name ends in {@code .gz}) one by one,
 * with their fields between blanks and tabs; memory use does not depend on the size of the file.
 */
public final class TextLines implements Fields, Closeable {
  /** The greatest length of a line in characters. */
  static final int MAX_LINE = 1 << 20;

  /** The mark with which some editors begin UTF-8 files. */
  private static final String BYTE_ORDER_MARK = "\ufeff";

  private final String file;
  private final BufferedReader in;
  private int number;
  private String text = "";
  private final List<String> fields = new ArrayList<>();

  /** Reads a text that begins in a line of a file, counted from 1. */
  public TextLines(String file, Reader in, int firstLine) {
    this.file = file;
    this.in = new BufferedReader(new LimitedLines(in), 1 << 16);
    this.number = firstLine - 1;
  }

  /**
   * Opens a file.
   *
   * @throws InputException if the file is missing or cannot be read
   */
  public static TextLines open(Path path) {
    return new TextLines(
        path.toString(), new InputStreamReader(stream(path), StandardCharsets.UTF_8), 1);
  }

  /**
   * Opens the bytes of a file, decompressed if its name ends in {@code .gz} or {@code .svgz}.
   *
   * @throws InputException if the file is missing or cannot be read
   */
  public static InputStream stream(Path path) {
    if (Files.isDirectory(path) || !Files.exists(path)) {
      String problem = Files.isDirectory(path) ? "is a folder" : "no such file";
      throw new Place(path.toString(), 1, 1).error(problem + ", expected a file");
    }
    try {
      String name = path.toString().toLowerCase(Locale.ROOT);
      boolean packed = name.endsWith(".gz") || name.endsWith(".svgz");
      InputStream in = new BufferedInputStream(Files.newInputStream(path), 1 << 16);
      return packed ? new GZIPInputStream(in, 1 << 16) : in;
    } catch (IOException e) {
      throw unreadable(path.toString(), 1, e);
    }
  }

  /**
   * Moves to the next line; returns false at the end.
   *
   * @throws InputException if the file cannot be read
   */
  public boolean next() {
    try {
      number++;
      String line = in.readLine();
      text = line == null ? "" : line;
      if (number == 1 && text.startsWith(BYTE_ORDER_MARK)) {
        text = text.substring(1);
      }
      fields.clear();
      StringTokenizer split = new StringTokenizer(text, " \t");
      while (split.hasMoreTokens()) {
        fields.add(split.nextToken());
      }
      return line != null;
    } catch (IOException e) {
      throw unreadable(file, number, e);
    }
  }

  /**
   * Moves to the next line that has fields and does not start with {@code #}; returns false at the
   * end.
   *
   * @throws InputException if the file cannot be read
   */
  public boolean nextFields() {
    while (next()) {
      if (!fields.isEmpty() && !isComment()) {
        return true;
      }
    }
    return false;
  }

  /** Whether the line starts with {@code #}. */
  public boolean isComment() {
    return !fields.isEmpty() && fields.get(0).startsWith("#");
  }

  /** The line without its line end. */
  public String text() {
    return text;
  }

  /** The place where the line begins. */
  public Place place() {
    return new Place(file, number, 1);
  }

  @Override
  public int count() {
    return fields.size();
  }

  @Override
  public String text(int field) {
    return fields.get(field);
  }

  @Override
  public Place place(int field) {
    int end = 0;
    for (String before : fields.subList(0, Math.min(field, count()))) {
      end = text.indexOf(before, end) + before.length();
    }
    int begin = field < count() ? text.indexOf(fields.get(field), end) : text.length();
    return new Place(file, number, 1 + begin);
  }

  /** The error about a file that cannot be read. */
  public static InputException unreadable(String file, int line, IOException e) {
    String reason =
        e instanceof FileSystemException fault && fault.getReason() != null
            ? fault.getReason()
            : String.valueOf(e.getMessage());
    return new InputException(
        new Place(file, line, 1).line("cannot be read (" + reason + "), expected a text file"), e);
  }

  @Override
  public void close() {
    try {
      in.close();
    } catch (IOException e) {
      throw unreadable(file, number, e);
    }
  }

  /** Refuses lines that are too long for the memory, as in a binary file. */
  private static final class LimitedLines extends FilterReader {
    private int length;

    LimitedLines(Reader in) {
      super(in);
    }

    @Override
    public int read(char[] buffer, int start, int limit) throws IOException {
      int count = super.read(buffer, start, limit);
      for (int i = start; i < start + count; i++) {
        length = buffer[i] == '\n' || buffer[i] == '\r' ? 0 : length + 1;
      }
      if (length > MAX_LINE) {
        throw new IOException("a line has more than " + MAX_LINE + " characters");
      }
      return count;
    }
  }
}
