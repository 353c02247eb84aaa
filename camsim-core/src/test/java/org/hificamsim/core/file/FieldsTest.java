package org.hificamsim.core.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.StringReader;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FieldsTest {
  @Test
  void splitsAtRunsOfBlanksAndTabs() {
    assertEquals(List.of("1", "2", "3"), texts("  1 \t 2\t3  "));
    assertEquals(List.of(), texts(""));
    assertEquals(List.of(), texts(" \t "));
  }

  @Test
  void acceptsAnyNumberOfFields() {
    List<String> numbers = IntStream.range(0, 100).mapToObj(Integer::toString).toList();
    assertEquals(numbers, texts(String.join(" ", numbers)));
  }

  @Test
  void errorsNamePlaceOfField() {
    Fields fields = fields("  12  x7");
    assertEquals(12, fields.number(0, "x"));
    assertFault("t:5:7: y is 'x7', expected a finite number", () -> fields.number(1, "y"));
    assertFault("t:5:9: the line has no z, expected a finite number", () -> fields.number(2, "z"));
  }

  @ParameterizedTest
  @CsvSource({
    "1, 1",
    "-1.5e3, -1500",
    ".5, 0.5",
    "+2., 2",
    "1E-3, 0.001",
    "1e9, 1e9",
    "-1e9, -1e9"
  })
  void readsDecimalNumbers(String text, double number) {
    assertEquals(number, Fields.value(text));
    assertEquals(number, fields(text).coordinate(0, "x"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"1f", "1d", "NaN", "Infinity", "0x1p3", "1e400", "", "1-2", "1,5"})
  void rejectsInvalidNumbers(String text) {
    assertThrows(InputException.class, () -> fields(text).number(0, "x"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"1000000001", "-1000000001"})
  void rejectsCoordinatesOutOfRange(String text) {
    String expected = "t:5:1: x is '" + text + "', expected a number from -1e9 to 1e9";
    assertFault(expected, () -> fields(text).coordinate(0, "x"));
  }

  @Test
  void errorsShowAtMostSixtyCharacters() {
    String sixty = "x".repeat(60);
    assertFault("t:5:1: x is '" + sixty + "', expected e", () -> invalid(sixty));
    assertFault("t:5:1: x is '" + sixty + "...', expected e", () -> invalid(sixty + "x"));
  }

  private static double invalid(String text) {
    return fields(text).number(0, "x", "e", value -> true);
  }

  private static void assertFault(String expected, Executable reads) {
    assertEquals(expected, assertThrows(InputException.class, reads).getMessage());
  }

  private static List<String> texts(String line) {
    Fields fields = fields(line);
    return IntStream.range(0, fields.count()).mapToObj(fields::text).toList();
  }

  /** Returns the fields of a text that is line 5 of a file. */
  private static Fields fields(String line) {
    TextLines lines = new TextLines("t", new StringReader(line + "\n"), 5);
    lines.next();
    return lines;
  }
}
