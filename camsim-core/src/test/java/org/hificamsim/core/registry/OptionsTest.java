package org.hificamsim.core.registry;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.spec.Headings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class OptionsTest {
  @Test
  void missingOptionsTakeDefaults() {
    Options options = Options.none("policy x");
    assertEquals(0.1, options.number("epsilon", 0.1, 0, 1, "exploration"));
    assertEquals(4, options.integer("k", 4, 1, 9, "neighbours"));
    assertEquals(List.of(1, 2), options.integers("levels", List.of(1, 2), 0, 9, "levels"));
    assertEquals(Headings.DEGREES, options.choice("unit", Headings.DEGREES, "unit"));
    assertEquals("t", options.text("name", "t", "name"));
    assertDoesNotThrow(options::rejectUnknown);
    assertEquals(
        List.of(
            new Options.Declared("epsilon", "0.1", "exploration"),
            new Options.Declared("k", "4", "neighbours"),
            new Options.Declared("levels", "1,2", "levels"),
            new Options.Declared("unit", "degrees", "unit"),
            new Options.Declared("name", "t", "name")),
        options.declared());
  }

  @Test
  void readsGivenOptions() {
    Options options =
        Options.parse("policy x", "epsilon=0.5, k = 3 ,levels=0,2,4,unit=as-radians,name=a=b");
    assertEquals("a=b", options.text("name", "t", ""));
    assertEquals(Headings.AS_RADIANS, options.choice("unit", Headings.DEGREES, ""));
    assertEquals(List.of(0, 2, 4), options.integers("levels", List.of(), 0, 9, ""));
    assertEquals(3, options.integer("k", 4, 1, 9, ""));
    assertEquals(0.5, options.number("epsilon", 0.1, 0, 1, ""));
    assertDoesNotThrow(options::rejectUnknown);
  }

  @Test
  void readsMainTextWithoutKey() {
    assertEquals("a,b.onnx", Options.parse("policy x", "a,b.onnx").mainText("file", "", ""));
    assertEquals("a=b.onnx", Options.parse("policy x", "file=a=b.onnx").mainText("file", "", ""));
    assertEquals("", Options.none("policy x").mainText("file", "", ""));
    Options both = Options.parse("policy x", "a.onnx,file=b.onnx");
    assertEquals("b.onnx", both.mainText("file", "", ""));
    assertThrows(InputException.class, both::rejectUnknown);
  }

  @Test
  void readsListWithoutKey() {
    Options options = Options.parse("policy fixed", "0,1, 2");
    assertEquals(List.of(0, 1, 2), options.integers("levels", List.of(), 0, 9, ""));
    assertDoesNotThrow(options::rejectUnknown);
    Options mixed = Options.parse("policy fixed", "3,seed=5");
    assertEquals(List.of(3), mixed.integers("levels", List.of(), 0, 9, ""));
    assertEquals(5, mixed.integer("seed", 0, 0, 9, ""));
  }

  @Test
  void rejectsListWithAndWithoutKey() {
    Options options = Options.parse("policy fixed", "0,1,levels=2");
    assertEquals(List.of(2), options.integers("levels", List.of(), 0, 9, ""));
    assertError(
        "policy fixed: unknown option '0,1', expected one of levels", options::rejectUnknown);
  }

  @Test
  void acceptsBothEndsOfRange() {
    assertEquals(0, Options.parse("x", "a=0").number("a", 1, 0, 1, ""));
    assertEquals(1, Options.parse("x", "a=1").number("a", 0, 0, 1, ""));
    assertEquals(2, Options.parse("x", "a=2").integer("a", 3, 2, 3, ""));
    assertEquals(3, Options.parse("x", "a=3").integer("a", 2, 2, 3, ""));
  }

  @ParameterizedTest
  @ValueSource(strings = {"-0.001", "1.001", "NaN", "Infinity", "-Infinity", "1e999", "abc", ""})
  void rejectsNumberOutOfRange(String text) {
    assertError(
        "x: a is '" + text + "', expected a number from 0.0 to 1.0",
        () -> Options.parse("x", "a=" + text).number("a", 0.5, 0, 1, ""));
  }

  @ParameterizedTest
  @ValueSource(strings = {"Infinity", "NaN", "1e999"})
  void rejectsInfiniteNumberWithoutUpperEnd(String text) {
    assertThrows(
        InputException.class,
        () -> Options.parse("x", "a=" + text).number("a", 1, 0, Double.POSITIVE_INFINITY, ""));
  }

  @ParameterizedTest
  @ValueSource(strings = {"1", "10", "2.5", "4294967298", "two", ""})
  void rejectsWholeNumberOutOfRange(String text) {
    assertError(
        "x: a is '" + text + "', expected a whole number from 2 to 9",
        () -> Options.parse("x", "a=" + text).integer("a", 3, 2, 9, ""));
  }

  @ParameterizedTest
  @ValueSource(strings = {"0,,2", "0,1,", "0,x", "0,10"})
  void rejectsInvalidItemOfList(String text) {
    assertThrows(
        InputException.class,
        () -> Options.parse("x", text).integers("levels", List.of(), 0, 9, ""));
  }

  @Test
  void rejectsUnknownChoiceAndListsKnownOnes() {
    assertError(
        "x: unit is 'DEGREES', expected one of degrees, as-radians",
        () -> Options.parse("x", "unit=DEGREES").choice("unit", Headings.DEGREES, ""));
  }

  @ParameterizedTest
  @ValueSource(strings = {"a=1,a=2", "=1", "a=1, =2", "a=1,b=2,a=1"})
  void rejectsRepeatedAndEmptyKeys(String text) {
    assertThrows(InputException.class, () -> Options.parse("x", text));
  }

  private static void assertError(String message, Executable executable) {
    assertEquals(message, assertThrows(InputException.class, executable).getMessage());
  }
}
