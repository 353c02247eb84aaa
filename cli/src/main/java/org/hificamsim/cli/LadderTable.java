package org.hificamsim.cli;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import org.hificamsim.reproduction.ladder.LadderFiles;
import org.hificamsim.reproduction.ladder.LadderResult;
import org.hificamsim.reproduction.ladder.RungResult;

/** The tables that a ladder prints when it is done: each scenario, then all with the costs. */
final class LadderTable {
  private final PrintWriter out;
  private final LadderResult result;
  private final String start;

  private LadderTable(PrintWriter out, LadderResult result) {
    this.out = out;
    this.result = result;
    int scenario = width(result.scenarios());
    int rung = width(result.rungs().stream().map(one -> one.rung().name()).toList());
    this.start = "%-" + scenario + "s  %-" + rung + "s  %7s  %20s  %23s  ";
  }

  static void print(PrintWriter out, LadderResult result) {
    LadderTable table = new LadderTable(out, result);
    table.line("scenario", "rung", "optimum", "tau [95%]", table.lost(), "chosen");
    for (RungResult one : result.rungs()) {
      if (!one.scenario().equals(RungResult.ALL)) {
        table.line(one, String.join(LadderFiles.OR, one.chosen()));
      }
    }
    out.println();
    table.all();
  }

  private String lost() {
    return result.measure() + " lost, % [95%]";
  }

  private void all() {
    line("scenario", "rung", "optimum", "tau [95%]", lost(), " ns/step  adds");
    List<RungResult> all = result.of(RungResult.ALL);
    for (int i = 0; i < all.size(); i++) {
      RungResult one = all.get(i);
      String cost = String.format(Locale.ROOT, "%8.0f  ", result.nanoseconds().get(i));
      line(one, cost + one.rung().adds());
    }
  }

  private void line(RungResult one, String end) {
    line(
        one.scenario(),
        one.rung().name(),
        String.format(Locale.ROOT, "%.3f", one.optimum().mean()),
        one.tau().text("%.2f"),
        one.share().times(100).text("%.1f"),
        end);
  }

  private void line(
      String scenario, String rung, String optimum, String tau, String lost, String end) {
    out.printf(Locale.ROOT, start, scenario, rung, optimum, tau, lost);
    out.println(end);
  }

  private static int width(List<String> texts) {
    return texts.stream().mapToInt(String::length).reduce(8, Math::max);
  }
}
