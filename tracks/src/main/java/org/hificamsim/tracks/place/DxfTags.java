package org.hificamsim.tracks.place;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.TextLines;

/** Reads the pairs of an ASCII DXF one by one: a group code and, in the next line, its value. */
final class DxfTags implements Closeable {
  private static final int MAX_LINE = 1 << 16;
  private static final String BINARY = "AutoCAD Binary DXF";
  private static final Pattern DWG = Pattern.compile("AC10\\d\\d.*", Pattern.DOTALL);
  private static final Pattern UNICODE = Pattern.compile("\\\\U\\+([0-9A-Fa-f]{4})");

  private final String file;
  private final InputStream in;
  private final byte[] buffer = new byte[MAX_LINE];
  private int line; // the number of lines that were read
  private int code;
  private String value = "";
  private boolean isHeld;
  private Charset codePage = Charset.forName("windows-1252");

  DxfTags(Path path) {
    this.file = path.toString();
    this.in = TextLines.stream(path);
  }

  /**
   * Moves to the next pair.
   *
   * @throws InputException if the file ends, or has no pair there
   */
  void next() {
    if (isHeld) {
      isHeld = false;
      return;
    }
    String text = readLine().strip();
    try {
      code = Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw notPairs(text).because(e);
    }
    value = readLine();
  }

  private InputException notPairs(String text) {
    if (line == 1 && (text.startsWith(BINARY) || DWG.matcher(text).matches())) {
      String kind = text.startsWith(BINARY) ? "a binary DXF" : "a DWG";
      return place().error("the file is " + kind + ", expected DXF in ASCII: save it as such");
    }
    return place().invalid("group code", Place.printable(text), "a whole number, as in ASCII DXF");
  }

  /** Makes the next call of {@link #next} return the same pair again. */
  void hold() {
    isHeld = true;
  }

  int code() {
    return code;
  }

  /** Whether the pair has a code and a value. */
  boolean is(int expectedCode, String expectedValue) {
    return code == expectedCode && value.strip().equals(expectedValue);
  }

  /** The value without blanks around it, with one character for each byte. */
  String value() {
    return value.strip();
  }

  /** The value as a name, in the encoding of the file. */
  String name() {
    byte[] bytes = value().getBytes(StandardCharsets.ISO_8859_1);
    String text;
    try {
      text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
    } catch (CharacterCodingException e) {
      text = new String(bytes, codePage);
    }
    return UNICODE
        .matcher(text)
        .replaceAll(
            escape ->
                Matcher.quoteReplacement(
                    String.valueOf((char) Integer.parseInt(escape.group(1), 16))));
  }

  /** Sets the encoding of names that are not UTF-8, such as ANSI_1251; ignores unknown ones. */
  void setCodePage(String name) {
    String charset = name.toLowerCase(Locale.ROOT).replace("ansi_", "windows-");
    if (charset.matches("[a-z0-9][a-z0-9-]*") && Charset.isSupported(charset)) {
      codePage = Charset.forName(charset);
    }
  }

  /** The value as a number from -1e100 to 1e100. */
  double number() {
    try {
      double number = Double.parseDouble(value());
      if (Math.abs(number) <= 1e100) {
        return number;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw invalid("a number");
  }

  int integer() {
    try {
      return Integer.parseInt(value());
    } catch (NumberFormatException e) {
      throw invalid("a whole number").because(e);
    }
  }

  private InputException invalid(String expected) {
    return place().invalid("group " + code, Place.printable(value()), expected);
  }

  /** The line of the value. */
  Place place() {
    return new Place(file, Math.max(1, line), 1);
  }

  private String readLine() {
    line++;
    int length = 0;
    try {
      for (int next = in.read(); next != '\n'; next = in.read()) {
        if (next < 0 && length == 0) {
          throw place().error("the file is cut off, expected an ASCII DXF that ends with EOF");
        }
        if (next < 0) {
          break;
        }
        if (length == MAX_LINE) {
          throw place().error("a line is longer than %s bytes, expected DXF in ASCII", MAX_LINE);
        }
        buffer[length++] = (byte) next;
      }
    } catch (IOException e) {
      throw TextLines.unreadable(file, line, e);
    }
    int end = length > 0 && buffer[length - 1] == '\r' ? length - 1 : length;
    return new String(buffer, 0, end, StandardCharsets.ISO_8859_1);
  }

  @Override
  public void close() {
    try {
      in.close();
    } catch (IOException e) {
      throw TextLines.unreadable(file, line, e);
    }
  }
}
