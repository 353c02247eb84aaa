package org.hificamsim.hifi.feature;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ExpressionTest {
  private static final double Q = 0.5;
  private static final double D = 4;
  private static final double Z = 0.05;

  @ParameterizedTest
  @CsvSource({
    "1, 1",
    "q, 0.5",
    "d, 4",
    "z, 0.05",
    "1 - 2 - 3, -4",
    "8 / 4 / 2, 1",
    "1 + 2 * 3, 7",
    "(1 + 2) * 3, 9",
    "-d * 2, -8",
    "--d, 4",
    "2 - -1, 3",
    "1.5e1 + .5, 15.5",
    "2.e-1, 0.2",
    "'  ( q+d )*z ', 0.225",
    "1 / q, 2",
  })
  void keepsTheUsualOrderOfOperations(String text, double value) {
    assertEquals(value, Expression.parse(text).value(Q, D, Z), 1e-15);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "''      | at character 1, not the end",
        "1 +     | at character 4, not the end",
        "(z      | expected ')' at character 3, not the end",
        "z)      | expected an operator or the end at character 2, not ')'",
        "2 z     | expected an operator or the end at character 3, not 'z'",
        "x       | at character 1, not 'x'",
        "q^2     | expected an operator or the end at character 2, not '^'",
        "e3      | at character 1, not 'e'",
        ".       | at character 1, not '.'",
        "1e      | at character 1, not '1'",
        "1 + 1e999 | at character 5, not '1'",
        "1,5     | at character 2, not ','",
        "NaN     | at character 1, not 'N'",
      })
  void errorsNameExpectationAndCharacter(String text, String part) {
    String message =
        assertThrows(IllegalArgumentException.class, () -> Expression.parse(text)).getMessage();
    assertTrue(message.startsWith("expected ") && message.contains(part), message);
  }

  @Test
  void rejectsDeeplyNestedFormula() {
    String brackets = "(".repeat(1500) + "z" + ")".repeat(1500);
    assertThrows(IllegalArgumentException.class, () -> Expression.parse(brackets));
    assertThrows(IllegalArgumentException.class, () -> Expression.parse("-".repeat(3000) + "z"));
    assertThrows(IllegalArgumentException.class, () -> Expression.parse("z+".repeat(3000) + "z"));
    assertEquals(2000 * Z, Expression.parse("z+".repeat(1999) + "z").value(Q, D, Z), 1e-9);
  }

  @Test
  void acceptsFormulaOfTheLargestSizeAndDepth() {
    assertEquals(Z, Expression.parse(" ".repeat(3999) + "z").value(Q, D, Z));
    assertThrows(IllegalArgumentException.class, () -> Expression.parse(" ".repeat(4000) + "z"));
    assertEquals(-Z, Expression.parse("-".repeat(199) + "z").value(Q, D, Z));
    assertThrows(IllegalArgumentException.class, () -> Expression.parse("-".repeat(200) + "z"));
  }

  @Property
  void readsEveryNumberExactly(@ForAll long bits) {
    double number = Double.longBitsToDouble(bits);
    if (Double.isFinite(number)) {
      assertEquals(number, Expression.parse(Double.toString(number)).value(Q, D, Z));
    }
  }

  @Test
  void formulasAreEqualIfTheirTextsAreEqual() {
    assertEquals(Expression.parse("z + q"), Expression.parse("z + q"));
    assertEquals(Expression.parse("z + q").hashCode(), Expression.parse("z + q").hashCode());
    assertNotEquals(Expression.parse("z + q"), Expression.parse("q + z"));
    assertEquals("z + q", Expression.parse("z + q").toString());
  }
}
