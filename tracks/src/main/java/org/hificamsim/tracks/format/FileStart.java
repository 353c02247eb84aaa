package org.hificamsim.tracks.format;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;

/** The beginning of a file, unpacked, by which formats recognise it. */
public final class FileStart {
  private static final int MAX_BYTES = 1 << 16;
  private static final Pattern LINE = Pattern.compile("[^\r\n]*(\r\n|\n|\r|$)");
  private static final Pattern TAG = Pattern.compile("<([A-Za-z_][^\\s/>]*)");

  private final Path file;
  private final String text;
  private final List<String> comments = new ArrayList<>();
  private final List<LineFields> rows = new ArrayList<>();
  private Separator separator = Separator.BLANKS;

  private FileStart(Path file, byte[] bytes) {
    this.file = file;
    String decoded = new String(bytes, StandardCharsets.UTF_8);
    text = decoded.startsWith("\ufeff") ? decoded.substring(1) : decoded;
    boolean isWhole = bytes.length < MAX_BYTES;
    Matcher line = LINE.matcher(text);
    for (int number = 1; line.find() && (isWhole || line.end() < text.length()); number++) {
      addLine(new Place(file.toString(), number, 1), line.group().strip());
    }
  }

  private void addLine(Place place, String line) {
    if (line.startsWith("#")) {
      comments.add(line);
    } else if (!line.isEmpty()) {
      separator = rows.isEmpty() ? Separator.of(line) : separator;
      rows.add(new LineFields(place, line, separator));
    }
  }

  /**
   * Reads the beginning of a file, unpacked if its name ends in {@code .gz}.
   *
   * @throws org.hificamsim.core.InputException if it is missing or cannot be read
   */
  static FileStart of(Path file) {
    try (InputStream in = TextLines.stream(file)) {
      return new FileStart(file, in.readNBytes(MAX_BYTES));
    } catch (IOException e) {
      throw TextLines.unreadable(file.toString(), 1, e);
    }
  }

  /** The text, as UTF-8. */
  String text() {
    return text;
  }

  /** The lines that begin with #, each with it. */
  List<String> comments() {
    return comments;
  }

  /** The other lines that are not empty and are complete, cut at the separator. */
  List<LineFields> rows() {
    return rows;
  }

  /** The separator of the first row's columns. */
  Separator separator() {
    return separator;
  }

  /** The number of columns in the first row; 0 without rows. */
  int columns() {
    return rows.isEmpty() ? 0 : rows.get(0).count();
  }

  /** Whether the first row consists of numbers. */
  boolean hasNumbers() {
    return !rows.isEmpty() && rows.get(0).areNumbers();
  }

  boolean isXml() {
    return text.stripLeading().startsWith("<");
  }

  boolean isJson() {
    String start = text.stripLeading();
    return start.startsWith("{") || start.startsWith("[");
  }

  boolean isSqlite() {
    return text.startsWith("SQLite format 3\0");
  }

  /** Whether the file may be a table: neither XML nor JSON nor binary. */
  boolean isTable() {
    return !rows.isEmpty() && !isXml() && !isJson() && text.indexOf('\0') < 0;
  }

  /** The name of the first element of an XML file; empty if there is none. */
  String rootElement() {
    Matcher tag = TAG.matcher(text.replaceAll("(?s)<!--.*?-->", ""));
    return isXml() && tag.find() ? tag.group(1) : "";
  }

  /** The place of the first row, or of the beginning. */
  Place place() {
    return rows.isEmpty() ? new Place(file.toString(), 1, 1) : rows.get(0).place(0);
  }

  /** Describes the file, in words that follow "the file". */
  String look() {
    if (isSqlite()) {
      return "is an SQLite file";
    }
    if (isXml()) {
      return "begins with <" + rootElement() + ">";
    }
    if (isJson()) {
      return "is JSON";
    }
    return isTable()
        ? "has %s %s between %s"
            .formatted(columns(), hasNumbers() ? "numbers" : "fields", separator)
        : rows.isEmpty() ? "is empty" : "is binary";
  }
}
