package org.hificamsim.hifi.feature;

import org.hificamsim.hifi.feature.Expression.Term;

/** A recursive-descent reader of {@link Expression}s, with a bound on length and depth. */
final class ExpressionParser {
  private static final int MAX = 4_000;
  private static final int DEEPEST = 200;

  private final String text;
  private int next;
  private int depth;

  ExpressionParser(String text) {
    this.text = text;
  }

  Term parse() {
    if (text.length() > MAX) {
      throw new IllegalArgumentException(
          "expected at most " + MAX + " characters, not " + text.length());
    }
    Term term = sum();
    if (next < text.length()) {
      throw fault("an operator or the end");
    }
    return term;
  }

  private Term sum() {
    Term left = product();
    while (true) {
      Term first = left;
      if (accept('+')) {
        Term second = product();
        left = (q, d, z) -> first.at(q, d, z) + second.at(q, d, z);
      } else if (accept('-')) {
        Term second = product();
        left = (q, d, z) -> first.at(q, d, z) - second.at(q, d, z);
      } else {
        return left;
      }
    }
  }

  private Term product() {
    Term left = signed();
    while (true) {
      Term first = left;
      if (accept('*')) {
        Term second = signed();
        left = (q, d, z) -> first.at(q, d, z) * second.at(q, d, z);
      } else if (accept('/')) {
        Term second = signed();
        left = (q, d, z) -> first.at(q, d, z) / second.at(q, d, z);
      } else {
        return left;
      }
    }
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
    int start = next;
    skipDigits();
    if (next < text.length() && text.charAt(next) == '.') {
      next++;
      skipDigits();
    }
    int mantissaEnd = next;
    if (next < text.length() && (text.charAt(next) | 0x20) == 'e') {
      next++;
      if (next < text.length() && (text.charAt(next) == '-' || text.charAt(next) == '+')) {
        next++;
      }
      skipDigits();
    }
    try {
      double value = Double.parseDouble(text.substring(start, next));
      if (mantissaEnd > start && Double.isFinite(value)) {
        skipSpace();
        return (q, d, z) -> value;
      }
    } catch (NumberFormatException e) {
      // told below
    }
    next = start;
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

  private void skipDigits() {
    while (next < text.length() && text.charAt(next) >= '0' && text.charAt(next) <= '9') {
      next++;
    }
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
