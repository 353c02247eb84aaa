package org.hificamsim.reproduction;

import java.util.Locale;

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
      return off + camSim(cell);
    }
    return off + "; state, discount and reward of SARSA, and the targets, are not published";
  }

  private static String camSim(Table81.Cell cell) {
    String formula =
        cell.published().policy().equals(ReproductionPlans.ZOOM_OUT)
            ? "CamSim's formula, Eq 6.2, depends on the zoom alone and can give 0 or 1 here"
            : format("CamSim's formula, Eq 6.2, gives %.2f", cell.standard());
    return format(
        "; %s; its threshold is not published; camsim-range at 0.45 over the hi-fi optimum is %.2f",
        formula, cell.at45());
  }

  static String of(Statement statement) {
    Statement.Margin weakest = statement.weakest();
    String checks =
        format(
            "%d of %d checks hold; weakest: %s %s",
            statement.held(),
            statement.margins().size(),
            weakest.where(),
            weakest.value().text("%+.3f"));
    return statement.remark().isEmpty() ? checks : checks + "; " + statement.remark();
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
