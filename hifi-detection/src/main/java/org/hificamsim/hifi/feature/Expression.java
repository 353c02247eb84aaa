package org.hificamsim.hifi.feature;

import com.fasterxml.jackson.annotation.JsonValue;

/**
 * A formula of numbers, the variables {@code z}, {@code q} and {@code d}, the operators {@code + -
 * * /} and brackets, such as {@code 2*z - 0.36/q}. Two formulas are equal when their texts are.
 */
public final class Expression {
  private final String text;
  private final Term root;

  private Expression(String text, Term root) {
    this.text = text;
    this.root = root;
  }

  /**
   * Reads a formula.
   *
   * @throws IllegalArgumentException with what was expected at which character, in one line
   */
  public static Expression parse(String text) {
    return new Expression(text, new ExpressionParser(text).parse());
  }

  /** Returns the value in IEEE arithmetic (NaN for 0/0). All three variables are in metres. */
  public double value(double size, double distance, double focalLength) {
    return root.value(size, distance, focalLength);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Expression that && text.equals(that.text);
  }

  @Override
  public int hashCode() {
    return text.hashCode();
  }

  /** Returns the text that was parsed. */
  @Override
  @JsonValue
  public String toString() {
    return text;
  }

  /** A part of a formula, which has a value. */
  interface Term {
    double value(double size, double distance, double focalLength);
  }
}
