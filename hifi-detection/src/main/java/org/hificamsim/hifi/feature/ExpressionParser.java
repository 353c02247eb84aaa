package org.hificamsim.hifi.feature;

import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.hifi.feature.Expression.Term;

/** Parses {@link Expression}s by recursive descent, with limits on length and depth. */
final class ExpressionParser {
  /** The pattern of a number, also of a malformed one, so that errors show all of it. */
  private static final Pattern NUMBER = Pattern.compile("[0-9]*(\\.[0-9]*)?([eE][-+]?[0-9]*)?");

  private static final int MAX_LENGTH = 4_000;
  private static final int MAX_DEPTH = 200;

  private final String text;
  private int position;
  private int depth;

  ExpressionParser(String text) {
    this.text = text;
  }

  Term parse() {
    if (text.length() > MAX_LENGTH) {
      throw new IllegalArgumentException(
          "expected at most " + MAX_LENGTH + " characters, not " + text.length());
    }
    Term term = sum();
    if (position < text.length()) {
      throw error("an operator or the end");
    }
    return term;
  }

  private Term sum() {
    return chain("+-", this::product);
  }

  private Term product() {
    return chain("*/", this::signed);
  }

  /** Parses parts that are joined by these operators, from left to right. */
  private Term chain(String operators, Supplier<Term> part) {
    Term left = part.get();
    while (position < text.length() && operators.indexOf(text.charAt(position)) >= 0) {
      char operator = text.charAt(position);
      accept(operator);
      left = operation(left, operator, part.get());
    }
    return left;
  }

  private static Term operation(Term first, char operator, Term second) {
    return switch (operator) {
      case '+' -> (q, d, z) -> first.value(q, d, z) + second.value(q, d, z);
      case '-' -> (q, d, z) -> first.value(q, d, z) - second.value(q, d, z);
      case '*' -> (q, d, z) -> first.value(q, d, z) * second.value(q, d, z);
      default -> (q, d, z) -> first.value(q, d, z) / second.value(q, d, z);
    };
  }

  private Term signed() {
    if (++depth > MAX_DEPTH) {
      throw error("at most " + MAX_DEPTH + " nested parts");
    }
    Term term;
    if (accept('-')) {
      Term positive = signed();
      term = (q, d, z) -> -positive.value(q, d, z);
    } else {
      term = atom();
    }
    depth--;
    return term;
  }

  private Term atom() {
    if (accept('(')) {
      Term inner = sum();
      if (!accept(')')) {
        throw error("')'");
      }
      return inner;
    }
    if (accept('q')) {
      return (q, d, z) -> q;
    }
    if (accept('d')) {
      return (q, d, z) -> d;
    }
    if (accept('z')) {
      return (q, d, z) -> z;
    }
    return number();
  }

  private Term number() {
    Matcher number = NUMBER.matcher(text).region(position, text.length());
    try {
      double value = number.lookingAt() ? Double.parseDouble(number.group()) : Double.NaN;
      if (Double.isFinite(value)) {
        position = number.end();
        skipSpace();
        return (q, d, z) -> value;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw error("a finite number, z, q, d, '-' or '('");
  }

  private boolean accept(char wanted) {
    skipSpace();
    if (position == text.length() || text.charAt(position) != wanted) {
      return false;
    }
    position++;
    skipSpace();
    return true;
  }

  private void skipSpace() {
    while (position < text.length() && text.charAt(position) == ' ') {
      position++;
    }
  }

  private IllegalArgumentException error(String expected) {
    String found = position < text.length() ? "'" + text.charAt(position) + "'" : "the end";
    return new IllegalArgumentException(
        "expected " + expected + " at character " + (position + 1) + ", not " + found);
  }
}
