package org.hificamsim.hifi.json;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Function;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;

/** Tests the bounds of each type of property, on both sides. */
class JsonObjectTest {
  @Test
  void rejectsNumbersOutsideTheirBounds() {
    assertEquals(0.5, object("{\"x\": 0.5}").number("x", 0.5, 2));
    assertEquals(2, object("{\"x\": 2}").number("x", 0.5, 2));
    String bounds = "expected a number from 0.5 to 2.0";
    assertFault("x is 0.499, " + bounds, "{\"x\": 0.499}", object -> object.number("x", 0.5, 2));
    assertFault("x is 2.001, " + bounds, "{\"x\": 2.001}", object -> object.number("x", 0.5, 2));
  }

  @Test
  void rejectsTooManyRows() {
    String table = "{\"t\": [[0, 1], [1, 0]]}";
    assertArrayEquals(new double[][] {{0, 1}, {1, 0}}, object(table).rows("t", 2, 2, 0, 1));
    String expected = "t is a list of 2, expected a list of 1 to 1 rows";
    assertFault(expected, table, object -> object.rows("t", 2, 1, 0, 1));
    assertFault(
        "t is a list of 0, expected", "{\"t\": []}", object -> object.rows("t", 2, 2, 0, 1));
  }

  @Test
  void rejectsCellsOutsideTheirBounds() {
    assertArrayEquals(new double[] {-1, 3}, object("{\"b\": [-1, 3]}").numbers("b", 2, -1, 3));
    String expected = ", expected numbers from -1.0 to 3.0";
    assertFault(
        "b holds 3.5" + expected, "{\"b\": [0, 3.5]}", object -> object.numbers("b", 2, -1, 3));
    assertFault(
        "b holds -2" + expected, "{\"b\": [-2, 0]}", object -> object.numbers("b", 2, -1, 3));
    assertFault(
        "expected lists of 2 numbers", "{\"b\": [0]}", object -> object.numbers("b", 2, -1, 3));
    assertFault(
        "expected lists of 2 numbers",
        "{\"b\": [0, 1, 2]}",
        object -> object.numbers("b", 2, -1, 3));
  }

  @Test
  void rejectsOtherValuesInListOfObjects() {
    List<JsonObject> objects = object("{\"o\": [{\"x\": 1}, {\"x\": 2}]}").objects("o");
    assertEquals(
        List.of(1.0, 2.0), objects.stream().map(object -> object.number("x", 0, 9)).toList());
    assertFault("o is 5, expected a list of objects", "{\"o\": 5}", object -> object.objects("o"));
    assertFault(
        "f:1:11: o holds 5, expected objects", "{\"o\": [{},5]}", object -> object.objects("o"));
  }

  @Test
  void showsTextsUpToSixtyCharacters() {
    String sixty = "x".repeat(60);
    assertFault(
        "x is '" + sixty + "', ", "{\"x\": \"" + sixty + "\"}", object -> object.number("x", 0, 1));
    assertFault(
        "x is '" + sixty + "...', ",
        "{\"x\": \"" + sixty + "y\"}",
        object -> object.object("x", JsonObject::texts));
  }

  private static JsonObject object(String text) {
    return JsonFile.parse("f", text.getBytes(StandardCharsets.UTF_8));
  }

  private static void assertFault(String part, String text, Function<JsonObject, Object> read) {
    String message =
        assertThrows(InputException.class, () -> read.apply(object(text))).getMessage();
    assertEquals(part, message.contains(part) ? part : message);
  }
}
