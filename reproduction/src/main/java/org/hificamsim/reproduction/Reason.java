package org.hificamsim.reproduction;

import java.util.Locale;
import org.hificamsim.runs.Estimate;

/** The reason for a verdict, in one line. */
final class Reason {
  private Reason() {}

  static String id(Table81.Cell cell) {
    return String.join(
        "/",
        cell.published().layout().label(),
        cell.published().policy(),
        cell.published().hifi() ? "hifi" : "camsim");
  }

  static String of(Table81.Cell cell) {
    String off = format("off by %+.2f", cell.difference());
    if (cell.verdict() != Verdict.NOT_REPRODUCED) {
      return off;
    }
    if (!cell.published().hifi()) {
      return off
          + format(
              "; CamSim's formula and threshold are not published; at 0.45 and over the hi-fi"
                  + " optimum it is %.2f",
              cell.at45());
    }
    return off + "; state, discount and reward of SARSA, and the targets, are not published";
  }

  static String of(Statement statement) {
    Statement.Margin weakest = statement.weakest();
    Estimate value = weakest.value();
    String checks =
        format(
            "%d of %d checks hold; weakest: %s %+.3f [%+.3f, %+.3f]",
            statement.held(),
            statement.margins().size(),
            weakest.where(),
            value.mean(),
            value.low(),
            value.high());
    return statement.remark().isEmpty() ? checks : checks + "; " + statement.remark();
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
