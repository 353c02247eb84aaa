package org.hificamsim.hifi.feature;

import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.hifi.feature.Expression.Term;

/** A recursive-descent reader of {@link Expression}s, with a bound on length and depth. */
final class ExpressionParser {
  /** As far as a number goes, a broken one too. */
  private static final Pattern NUMBER = Pattern.compile("[0-9]*(\\.[0-9]*)?([eE][-+]?[0-9]*)?");

  private static final int MAX_LENGTH = 4_000;
  private static final int DEEPEST = 200;

  private final String text;
  private int next;
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
    if (next < text.length()) {
      throw fault("an operator or the end");
    }
    return term;
  }

  private Term sum() {
    return chain("+-", this::product);
  }

  private Term product() {
    return chain("*/", this::signed);
  }

  /** Parts with these operators in between, from the left. */
  private Term chain(String operators, Supplier<Term> part) {
    Term left = part.get();
    while (next < text.length() && operators.indexOf(text.charAt(next)) >= 0) {
      char operator = text.charAt(next);
      accept(operator);
      left = operation(left, operator, part.get());
    }
    return left;
  }

  private static Term operation(Term first, char operator, Term second) {
    return switch (operator) {
      case '+' -> (q, d, z) -> first.at(q, d, z) + second.at(q, d, z);
      case '-' -> (q, d, z) -> first.at(q, d, z) - second.at(q, d, z);
      case '*' -> (q, d, z) -> first.at(q, d, z) * second.at(q, d, z);
      default -> (q, d, z) -> first.at(q, d, z) / second.at(q, d, z);
    };
  }

  private Term signed() {
    if (++depth > DEEPEST) {
      throw fault("at most " + DEEPEST + " nested parts");
    }
    Term term;
    if (accept('-')) {
      Term positive = signed();
      term = (q, d, z) -> -positive.at(q, d, z);
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
        throw fault("')'");
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
    Matcher number = NUMBER.matcher(text).region(next, text.length());
    try {
      double value = number.lookingAt() ? Double.parseDouble(number.group()) : Double.NaN;
      if (Double.isFinite(value)) {
        next = number.end();
        skipSpace();
        return (q, d, z) -> value;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw fault("a finite number, z, q, d, '-' or '('");
  }

  private boolean accept(char wanted) {
    skipSpace();
    if (next == text.length() || text.charAt(next) != wanted) {
      return false;
    }
    next++;
    skipSpace();
    return true;
  }

  private void skipSpace() {
    while (next < text.length() && text.charAt(next) == ' ') {
      next++;
    }
  }

  private IllegalArgumentException fault(String expected) {
    String found = next < text.length() ? "'" + text.charAt(next) + "'" : "the end";
    return new IllegalArgumentException(
        "expected " + expected + " at character " + (next + 1) + ", not " + found);
  }
}
