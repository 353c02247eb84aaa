package org.hificamsim.runs.benchmark;

import static java.util.stream.Collectors.joining;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.Table;
import org.hificamsim.runs.statistics.Aggregate;
import org.hificamsim.runs.statistics.Strata;

/** Checked entries, the best first: those that lack tasks come last, and have no place. */
public record Leaderboard(Benchmark benchmark, List<BenchmarkEntry> entries) {
  /** A figure of an entry: in a task, or of all. */
  private record Figure(BenchmarkEntry of, String task, String statistic, Estimate value) {}

  private static final Table<Figure> TABLE =
      Table.<Figure>of("leaderboard.csv")
          .texts("name", "of the entry", row -> row.of.name())
          .texts("policy", "the policy with its options", row -> row.of.policy())
          .texts("task", "the task; empty for all", Figure::task)
          .texts("statistic", "mean, or one of all tasks", Figure::statistic)
          .estimates("value", "", "share", "normalised", Figure::value);

  /** Sorts the entries. */
  public Leaderboard {
    entries =
        entries.stream()
            .sorted(
                Comparator.comparing((BenchmarkEntry one) -> !isWhole(benchmark, one))
                    .thenComparing(one -> -Aggregate.IQM.of(strata(benchmark, one)))
                    .thenComparing(BenchmarkEntry::name))
            .toList();
  }

  private static boolean isWhole(Benchmark benchmark, BenchmarkEntry entry) {
    return entry.tasks().keySet().containsAll(benchmark.names());
  }

  private static Strata strata(Benchmark benchmark, BenchmarkEntry entry) {
    return Strata.of(
        entry.tasks().keySet().stream().map(task -> entry.normalized(benchmark, task)).toList());
  }

  /** Adds the table and the page to a folder's files. */
  public void write(OutputFolder folder) throws IOException {
    List<List<Figure>> figures = entries.stream().map(this::figures).toList();
    TABLE.write(folder, figures.stream().flatMap(List::stream));
    String titles =
        Stream.concat(Stream.of("Entry", "IQM", "Mean"), benchmark.names().stream())
            .map(name -> "<th scope=\"col\">" + name + "</th>")
            .collect(joining());
    String rows = figures.stream().map(this::row).collect(joining("\n"));
    String page =
        new String(Io.resource(Leaderboard.class, "leaderboard.html"), StandardCharsets.UTF_8);
    folder.write("leaderboard.html", page.formatted(ManifestFile.version(), titles, rows));
  }

  /** One line for each entry: what it has in all tasks, or in those that it has. */
  public List<String> lines() {
    return entries.stream().map(one -> line(one, figures(one))).toList();
  }

  private String line(BenchmarkEntry entry, List<Figure> figures) {
    return isWhole(benchmark, entry)
        ? value(figures, "", Aggregate.IQM.label()) + "  " + entry.name()
        : figures.stream()
            .map(one -> one.task + " " + one.value.text("%.3f"))
            .collect(joining(", ", "-  " + entry.name() + ", no place without all tasks: ", ""));
  }

  private List<Figure> figures(BenchmarkEntry entry) {
    List<Figure> figures = new ArrayList<>();
    if (isWhole(benchmark, entry)) {
      Map<Aggregate, Estimate> all = Aggregate.estimates(strata(benchmark, entry));
      for (Aggregate one : Aggregate.values()) {
        figures.add(new Figure(entry, "", one.label(), all.get(one)));
      }
    }
    for (String task : entry.tasks().keySet()) {
      Estimate mean = Estimate.mean(entry.normalized(benchmark, task));
      figures.add(new Figure(entry, task, "mean", mean));
    }
    return figures;
  }

  private String row(List<Figure> figures) {
    Stream<String> all =
        Stream.of(Aggregate.IQM, Aggregate.MEAN).map(one -> value(figures, "", one.label()));
    Stream<String> each = benchmark.names().stream().map(task -> value(figures, task, "mean"));
    String cells = Stream.concat(all, each).collect(joining("</td><td>", "<td>", "</td>"));
    return "<tr><th scope=\"row\">%s</th>%s</tr>"
        .formatted(escaped(figures.get(0).of.name()), cells);
  }

  private static String value(List<Figure> figures, String task, String of) {
    return figures.stream()
        .filter(one -> one.task.equals(task) && one.statistic.equals(of))
        .findFirst()
        .map(one -> one.value.text("%.3f"))
        .orElse("-");
  }

  private static String escaped(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
  }
}
