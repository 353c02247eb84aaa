package org.hificamsim.core;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class PlaceTest {
  private static final Place PLACE = new Place("town.xml", 3, 14);

  @Test
  void errorBeginsWithPlace() {
    assertEquals("town.xml:3:14", PLACE.toString());
    assertEquals("town.xml:3:14: no width", PLACE.error("no width").getMessage());
  }

  @Test
  void escapesControlCharacters() {
    assertEquals(
        "a\\u001B[31mb c\\u009Bd \\u202Ee",
        Place.printable("a\u001b[31mb\r\n\u2028c\u009bd\t\u202ee"));
    assertEquals("a b:1:1: c d", new Place("a\nb", 1, 1).line("c\td"));
  }

  @Test
  void truncatesLongTextButKeepsExpectation() {
    String longest = "x".repeat(500);
    assertEquals("town.xml:3:14: " + longest, PLACE.line(longest));
    assertEquals("town.xml:3:14: " + longest + "...", PLACE.line(longest + "y"));
    String expected = ", expected columns";
    String start = "x".repeat(500 - expected.length());
    assertEquals("town.xml:3:14: " + start + "..." + expected, PLACE.line(longest + expected));
    String far = ", expected " + "y".repeat(300);
    assertEquals("town.xml:3:14: " + longest + "...", PLACE.line(longest + far));
  }
}
