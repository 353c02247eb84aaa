package org.hificamsim.cli;

import java.io.PrintWriter;
import java.util.Locale;
import org.hificamsim.reproduction.Adapting;
import org.hificamsim.reproduction.FitRole;
import org.hificamsim.reproduction.Judgement;
import org.hificamsim.reproduction.Statement;
import org.hificamsim.reproduction.Table81;
import org.hificamsim.reproduction.Verdict;

/** The tables that a reproduction prints when it is done. */
final class JudgementTable {
  private JudgementTable() {}

  static void print(PrintWriter out, Judgement judgement) {
    out.println(Adapting.finding(judgement.adapting()));
    out.println();
    out.printf(
        "%-8s %-15s %-9s %9s  %-20s %6s  %-8s %s%n",
        "layout", "policy", "detection", "published", "ours [95%]", "Eq 6.2", "role", "verdict");
    for (Table81.Cell cell : judgement.cells()) {
      out.printf(
          Locale.ROOT,
          "%-8s %-15s %-9s %9.2f  %-20s %6s  %-8s %s%n",
          cell.published().layout().label(),
          cell.published().policy(),
          cell.published().hifi() ? "hi-fi" : "CamSim",
          cell.published().proportion(),
          cell.ours().text("%.3f"),
          Double.isNaN(cell.standard()) ? "" : String.format(Locale.ROOT, "%.2f", cell.standard()),
          cell.role().label(),
          cell.verdict().label());
    }
    out.println();
    for (Statement statement : judgement.statements()) {
      out.printf(
          "%-15s %-8s %s%n",
          statement.verdict().label(), statement.role().label(), statement.text());
    }
    out.println();
    for (FitRole role : FitRole.values()) {
      out.printf("%-15s %s%n", role.label(), judgement.score(role));
    }
    for (Verdict verdict : Verdict.values()) {
      out.printf("%-15s %s%n", verdict.label(), judgement.score(verdict));
    }
  }
}
