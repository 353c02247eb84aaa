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
 * The lines of a text file (UTF-8; unpacked where its name ends in {@code .gz}), one at a time, so
 * that a file of any size takes little memory, and the fields of a line between blanks and tabs.
 */
public final class TextLines implements Fields, Closeable {
  /** Characters of a line; no line of numbers comes near it. */
  static final int MAX_LINE = 1 << 20;

  private static final String MARK = "\ufeff"; // that some editors put before UTF-8

  private final String file;
  private final BufferedReader in;
  private int number;
  private String text = "";
  private final List<String> fields = new ArrayList<>();

  /** The lines of a text that is part of a file and begins in one of its lines, from 1. */
  public TextLines(String file, Reader in, int firstLine) {
    this.file = file;
    this.in = new BufferedReader(new ShortLines(in), 1 << 16);
    this.number = firstLine - 1;
  }

  /**
   * Opens a file.
   *
   * @throws InputException when it is missing or cannot be read
   */
  public static TextLines open(Path path) {
    return new TextLines(
        path.toString(), new InputStreamReader(stream(path), StandardCharsets.UTF_8), 1);
  }

  /**
   * Opens a file's bytes, unpacked where its name ends in {@code .gz}.
   *
   * @throws InputException when it is missing or cannot be read
   */
  public static InputStream stream(Path path) {
    if (Files.isDirectory(path) || !Files.exists(path)) {
      String problem = Files.isDirectory(path) ? "is a folder" : "no such file";
      throw new Place(path.toString(), 1, 1).error(problem + ", expected a file");
    }
    try {
      boolean packed = path.toString().toLowerCase(Locale.ROOT).endsWith(".gz");
      InputStream in = new BufferedInputStream(Files.newInputStream(path), 1 << 16);
      return packed ? new GZIPInputStream(in, 1 << 16) : in;
    } catch (IOException e) {
      throw unreadable(path.toString(), 1, e);
    }
  }

  /**
   * Goes to the next line; false where there is none.
   *
   * @throws InputException when the file cannot be read on
   */
  public boolean next() {
    try {
      number++;
      String line = in.readLine();
      text = line == null ? "" : line;
      if (number == 1 && text.startsWith(MARK)) {
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
   * Goes to the next line that has fields and does not start with {@code #}; false where there is
   * none.
   *
   * @throws InputException when the file cannot be read on
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

  /** The line, without its end. */
  public String text() {
    return text;
  }

  /** The place where it begins. */
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

  /** The fault of a file that cannot be read on. */
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

  /** Lets no line through that would not fit into the memory, as in a file that is no text. */
  private static final class ShortLines extends FilterReader {
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
      if (length > MAX_LINE) {
        throw new IOException("a line has more than " + MAX_LINE + " characters");
      }
      return count;
    }
  }
}
