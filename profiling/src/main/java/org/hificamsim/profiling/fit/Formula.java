package org.hificamsim.profiling.fit;

import org.hificamsim.core.Texts;

/**
 * A formula of z, q, d, numbers and the four operations, as a tree that folds constants and prints
 * itself with as few brackets as possible.
 */
sealed interface Formula permits Formula.Constant, Formula.Variable, Formula.Operation {
  /** Returns the printed form, which {@code Expression} parses. */
  String text();

  /**
   * Returns the precedence of the outermost operation: 1 for sums, 2 for products, 3 for the rest.
   */
  int precedence();

  /** Returns the value for a row of the predictors q, d, z. */
  double evaluate(double[] row);

  /** A number. */
  record Constant(double value) implements Formula {
    @Override
    public String text() {
      String digits = Texts.format("%.5g", value);
      return digits.contains("e")
          ? digits
          : digits.replaceFirst("(\\.\\d*?)0+$", "$1").replaceFirst("\\.$", "");
    }

    @Override
    public int precedence() {
      return value < 0 ? 1 : 3;
    }

    @Override
    public double evaluate(double[] row) {
      return value;
    }
  }

  /** A predictor with its letter and its column. */
  record Variable(String text, int column) implements Formula {
    @Override
    public int precedence() {
      return 3;
    }

    @Override
    public double evaluate(double[] row) {
      return row[column];
    }
  }

  /** An operation on two formulas, one of + - * /. */
  record Operation(char sign, Formula left, Formula right) implements Formula {
    /** Returns the operation, simplified: constants are folded, x / x is 1 and x - x is 0. */
    static Formula of(char sign, Formula left, Formula right) {
      if (left.equals(right) && (sign == '/' || sign == '-') && !(left instanceof Constant)) {
        return new Constant(sign == '/' ? 1 : 0);
      }
      Operation operation = new Operation(sign, left, right);
      if (left instanceof Constant && right instanceof Constant) {
        double value = operation.evaluate(new double[0]);
        return Double.isFinite(value) ? new Constant(value) : operation;
      }
      if (sign == '*'
          && left instanceof Constant a
          && right instanceof Operation product
          && product.sign() == '*'
          && product.left() instanceof Constant b) {
        return new Operation('*', new Constant(a.value() * b.value()), product.right());
      }
      return operation;
    }

    @Override
    public String text() {
      String first = bracketed(left, precedence());
      int minPrecedence = sign == '-' || sign == '/' ? precedence() + 1 : precedence();
      String second =
          bracketed(right, right instanceof Constant n && n.value() < 0 ? 3 : minPrecedence);
      return precedence() == 1 ? first + " " + sign + " " + second : first + sign + second;
    }

    @Override
    public int precedence() {
      return sign == '+' || sign == '-' ? 1 : 2;
    }

    @Override
    public double evaluate(double[] row) {
      double a = left.evaluate(row);
      double b = right.evaluate(row);
      return switch (sign) {
        case '+' -> a + b;
        case '-' -> a - b;
        case '*' -> a * b;
        default -> a / b;
      };
    }

    private static String bracketed(Formula part, int minPrecedence) {
      return part.precedence() < minPrecedence ? "(" + part.text() + ")" : part.text();
    }
  }
}
