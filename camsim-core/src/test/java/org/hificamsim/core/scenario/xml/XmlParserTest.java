package org.hificamsim.core.scenario.xml;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Locale;
import java.util.SplittableRandom;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the places of elements and attributes, and errors of invalid XML. */
class XmlParserTest {
  @TempDir Path folder;

  @Test
  void placeOfElementIsItsOpeningTag() throws IOException {
    XmlElement root = parse("<root>\n  <a/><b></b>\n\t<c\n  x='1'\n/></root>");
    assertPlace(1, 1, root.place());
    assertPlace(2, 3, root.all("a").get(0).place());
    assertPlace(2, 7, root.all("b").get(0).place());
    assertPlace(3, 2, root.all("c").get(0).place());
  }

  @Test
  void findsAttributesOnSeveralLines() throws IOException {
    XmlElement a =
        parse("<root>\n <a\n   one='1'\n   two = '2' three\n=\n'3'\n/></root>").all("a").get(0);
    assertPlace(3, 4, a.place("one"));
    assertPlace(4, 4, a.place("two"));
    assertPlace(4, 14, a.place("three"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"\n", "\r\n", "\r"})
  void countsEveryKindOfLineEndOnce(String end) throws IOException {
    XmlElement a =
        parse("<root>#<!-- c#c -->#<a#  x='1'# y='2'/></root>".replace("#", end)).all("a").get(0);
    assertPlace(4, 1, a.place());
    assertPlace(5, 3, a.place("x"));
    assertPlace(6, 2, a.place("y"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        // a name that is the end, start or part of another
        "<a max_x='1' @x='2'/>",
        "<a x_max='1' @x='2'/>",
        "<a xx='1' @x='2'/>",
        "<a b:x='1' @x='2'/>",
        // a value that looks like an attribute
        "<a n=' x = 1 ' @x='2'/>",
        "<a n=\"' x='1'\" @x='2'/>",
        "<a n='>' @x='2'/>",
        "<a n='/>' @x='2'/>",
        "<a n='x'\t@x='2'/>",
        // spaces around the equals sign
        "<a  @x  =  '2'/>",
      })
  void findsAttributeAmongLookalikes(String marked) throws IOException {
    String text = "<r>" + marked + "</r>";
    XmlElement a = parse(text.replace("@", "")).all("a").get(0);
    assertEquals("2", a.attributes().get("x"));
    assertPlace(1, text.indexOf('@') + 1, a.place("x"));
  }

  @Test
  void findsAttributeFarFromItsEqualsSign() throws IOException {
    XmlElement a = parse("<r><a x" + " ".repeat(500) + "='2'/></r>").all("a").get(0);
    assertPlace(1, 7, a.place("x"));
  }

  @Test
  void placeOfMissingAttributeIsItsElement() throws IOException {
    assertPlace(2, 2, parse("<r>\n <a y='1'/></r>").all("a").get(0).place("x"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"UTF-8", "UTF-16LE", "UTF-16BE"})
  void acceptsByteOrderMark(String encoding) throws IOException {
    XmlElement root = parse("\uFEFF<r>\n <a x='ä'/></r>", Charset.forName(encoding));
    assertPlace(1, 1, root.place());
    assertPlace(2, 5, root.all("a").get(0).place("x"));
    assertEquals("ä", root.all("a").get(0).attributes().get("x"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"UTF-8", "UTF-16", "ISO-8859-1", "windows-1252"})
  void usesDeclaredEncoding(String encoding) throws IOException {
    String text = "<?xml version='1.0' encoding='" + encoding + "'?>\n<r ä='é'>é<a x='ü'/></r>";
    XmlElement root = parse(text, Charset.forName(encoding));
    assertPlace(2, 1, root.place());
    assertPlace(2, 4, root.place("ä"));
    assertPlace(2, 14, root.all("a").get(0).place("x"));
    assertEquals("ü", root.all("a").get(0).attributes().get("x"));
  }

  @Test
  void placesAreRightInLongFiles() throws IOException {
    SplittableRandom random = new SplittableRandom(1);
    StringBuilder text = new StringBuilder("<root>");
    for (int i = 0; i < 5000; i++) {
      text.append(random.nextInt(3) == 0 ? "\n" : " ".repeat(random.nextInt(9)));
      text.append(random.nextInt(9) == 0 ? "<!-- ä 😀 -->" : "");
      text.append("<a x='é😀' n").append(i).append("='1'/>");
    }
    XmlElement root = parse(text.append("</root>").toString());
    for (int i = 0; i < 5000; i++) {
      int at = text.indexOf("n" + i + "=");
      int lineStart = text.lastIndexOf("\n", at) + 1;
      int line = 1 + (int) text.substring(0, at).chars().filter(c -> c == '\n').count();
      assertPlace(line, at - lineStart + 1, root.children().get(i).place("n" + i));
    }
  }

  @Test
  void reportsErrorsInEnglishAndPrintsNothing() throws IOException {
    Locale before = Locale.getDefault();
    PrintStream err = System.err;
    ByteArrayOutputStream printed = new ByteArrayOutputStream();
    Locale.setDefault(Locale.GERMANY);
    System.setErr(new PrintStream(printed, true, StandardCharsets.UTF_8));
    try {
      assertEquals(
          "2:3: not well-formed XML, expected a scenario file: The element type \"a\" must be"
              + " terminated by the matching end-tag \"</a>\".",
          fault("<r><a>\n</r>".getBytes(StandardCharsets.UTF_8)));
      byte[] bytes = "<r>\n<a x='?'/></r>".getBytes(StandardCharsets.UTF_8);
      bytes[10] = (byte) 0xff;
      assertEquals("2:7: byte 0xFF is not UTF-8, expected text in that encoding", fault(bytes));
    } finally {
      Locale.setDefault(before);
      System.setErr(err);
    }
    assertEquals("", printed.toString(StandardCharsets.UTF_8));
  }

  @Test
  void rejectsDocumentTypeWithPlace() throws IOException {
    for (String encoding : new String[] {"UTF-8", "UTF-16"}) {
      String text =
          "<?xml version='1.0' encoding='%s'?>\n <!DOCTYPE r [<!ENTITY e '1'>]>\n<r>&e;</r>";
      assertEquals(
          "2:2: a document type declaration (<!DOCTYPE), expected a scenario without one",
          fault(text.formatted(encoding).getBytes(Charset.forName(encoding))));
    }
  }

  @Test
  void errorOfCutOffFileNamesOpenElement() throws IOException {
    assertEquals(
        "1:7: the file ends inside <b>, expected </b>",
        fault("<a><b>".getBytes(StandardCharsets.UTF_8)));
  }

  @Test
  void rejectsTooDeepNesting() throws IOException {
    parse("<a>".repeat(XmlParser.MAX_DEPTH) + "</a>".repeat(XmlParser.MAX_DEPTH));
    int most = XmlParser.MAX_DEPTH;
    assertEquals(
        "1:%s: <a> is nested too deep, expected at most 32 levels".formatted(3 * most + 1),
        fault("<a>".repeat(most + 1).getBytes(StandardCharsets.UTF_8)));
  }

  @Test
  void rejectsTooManyElementsAndAttributes() {
    byte[] text = ("<r>" + "<a/>".repeat(XmlParser.MAX_PARTS)).getBytes(StandardCharsets.UTF_8);
    assertTimeoutPreemptively(
        Duration.ofSeconds(60),
        () ->
            assertEquals(
                "1:%s: the file is too big, expected at most 4000000 elements, attributes"
                    .formatted(4 * XmlParser.MAX_PARTS),
                fault(text)));
  }

  @Test
  void findsManyPlacesQuickly() throws IOException {
    XmlElement root = parse("<r>" + "\n<a/>".repeat(200_000) + "</r>");
    assertTimeoutPreemptively(
        Duration.ofSeconds(60),
        () -> root.children().forEach(child -> assertEquals(1, child.place().column())));
  }

  @Test
  void rejectsMissingFileAndFolder() {
    InputException missing =
        assertThrows(InputException.class, () -> parsed(folder.resolve("no.xml")));
    assertTrue(missing.getMessage().endsWith("no.xml:1:1: no such file, expected a file"));
    InputException directory = assertThrows(InputException.class, () -> parsed(folder));
    assertTrue(directory.getMessage().endsWith(":1:1: is a folder, expected a file"));
  }

  private static void assertPlace(int line, int column, Place place) {
    assertEquals(line + ":" + column, place.line() + ":" + place.column());
  }

  private XmlElement parse(String text) throws IOException {
    return parse(text, StandardCharsets.UTF_8);
  }

  private XmlElement parse(String text, Charset charset) throws IOException {
    return parsed(Files.write(folder.resolve("test.xml"), text.getBytes(charset)));
  }

  private static XmlElement parsed(Path file) {
    return XmlParser.parse(file, warning -> {});
  }

  /** Returns the error message without the name of the file. */
  private String fault(byte[] bytes) throws IOException {
    Path file = Files.write(folder.resolve("test.xml"), bytes);
    String message = assertThrows(InputException.class, () -> parsed(file)).getMessage();
    return message.replace(file + ":", "");
  }
}
