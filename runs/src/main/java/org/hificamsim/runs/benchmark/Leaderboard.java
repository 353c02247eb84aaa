package org.hificamsim.runs.benchmark;

import static java.util.stream.Collectors.joining;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.output.Table;
import org.hificamsim.runs.statistics.Aggregate;
import org.hificamsim.runs.statistics.Strata;

/**
 * Checked entries, the best first. After those that have a rank come others, by {@link Standing},
 * and then the entries that lack tasks.
 */
public final class Leaderboard {
  private static final String MEAN = "mean";
  private static final String FORMAT = "%.3f";

  /** Whether an entry has a rank, and if not, why. */
  private enum Standing {
    RANKED(""),
    /** An entry whose actions only were replayed, while others were verified on fresh seeds. */
    UNVERIFIED("not verified, no rank"),
    /** An entry whose policy knows what no camera can know. */
    BOUND("a bound, out of competition"),
    /** An entry that scored more in testing than its policy does on fresh seeds. */
    NOT_HELD("does not hold on fresh seeds, no rank");

    private final String reason;

    Standing(String reason) {
      this.reason = reason;
    }

    /** The name of an entry, with the reason why it has no rank. */
    String mark(String name) {
      return reason.isEmpty() ? name : name + " (" + reason + ")";
    }
  }

  /** A figure of an entry: of one task, or of all if the task is empty. */
  private record Figure(
      BenchmarkEntry entry, String verified, String task, String statistic, Estimate value) {}

  private static final Table<Figure> TABLE =
      Table.<Figure>of("leaderboard.csv")
          .texts("name", "the name of the entry", figure -> figure.entry.name())
          .texts("policy", "the policy with its options", figure -> figure.entry.policy())
          .texts(
              "verified",
              "actions, fresh seeds, unconfined (fresh seeds, but the policy could read files), or"
                  + " not held",
              Figure::verified)
          .texts("task", "the task; empty for all", Figure::task)
          .texts("statistic", "mean, or one of all tasks", Figure::statistic)
          .estimates("value", "", "share", "normalised", Figure::value);

  private final Benchmark benchmark;
  private final List<BenchmarkEntry> entries;

  /** The outcome on fresh seeds by entry; only the actions of all other entries were replayed. */
  private final Map<BenchmarkEntry, VerificationOutcome> verified;

  /**
   * Ranks the entries.
   *
   * @param verified the outcome on fresh seeds, by entry
   * @throws InputException when names of entries look alike
   */
  public Leaderboard(
      Benchmark benchmark,
      List<BenchmarkEntry> entries,
      Map<BenchmarkEntry, VerificationOutcome> verified) {
    this.benchmark = benchmark;
    this.verified = Map.copyOf(verified);
    requireDistinctNames(entries);
    this.entries =
        entries.stream()
            .sorted(
                Comparator.comparing((BenchmarkEntry entry) -> !hasAllTasks(entry))
                    .thenComparing(this::standing)
                    .thenComparing(entry -> -Aggregate.interquartileMean(strata(entry)))
                    .thenComparing(BenchmarkEntry::name))
            .toList();
  }

  private static void requireDistinctNames(List<BenchmarkEntry> entries) {
    Map<String, String> names = new HashMap<>();
    for (BenchmarkEntry entry : entries) {
      String other = names.put(EntryName.skeleton(entry.name()), entry.name());
      if (other != null) {
        throw InputException.of(
            "the names of two entries look alike, '%s' and '%s', expected each in its own name",
            other, entry.name());
      }
    }
  }

  private Standing standing(BenchmarkEntry entry) {
    if (verified.get(entry) == VerificationOutcome.NOT_HELD) {
      return Standing.NOT_HELD;
    }
    if (benchmark.isBound(entry.policy())) {
      return Standing.BOUND;
    }
    return verified.isEmpty() || verified.containsKey(entry)
        ? Standing.RANKED
        : Standing.UNVERIFIED;
  }

  private String verification(BenchmarkEntry entry) {
    VerificationOutcome outcome = verified.get(entry);
    return outcome == null ? "actions" : outcome.label();
  }

  private boolean hasAllTasks(BenchmarkEntry entry) {
    return entry.tasks().keySet().containsAll(benchmark.names());
  }

  private Strata strata(BenchmarkEntry entry) {
    return Strata.of(
        entry.tasks().keySet().stream().map(task -> entry.normalized(benchmark, task)).toList());
  }

  /** Adds the table of all figures to a folder's files. */
  public void write(OutputFolder folder) throws IOException {
    TABLE.write(folder, entries.stream().flatMap(entry -> figures(entry).stream()));
  }

  /** Returns a line for each entry: its score in all tasks, or in those that it has played. */
  public List<String> lines() {
    return entries.stream().map(this::line).toList();
  }

  private String line(BenchmarkEntry entry) {
    List<Figure> figures = figures(entry);
    if (hasAllTasks(entry)) {
      String score = text(figures, "", Aggregate.IQM.label());
      return standing(entry) == Standing.RANKED
          ? Texts.format("%s  %-11s  %s", score, verification(entry), entry.name())
          : "-  " + marked(entry) + ": " + score;
    }
    return figures.stream()
        .map(figure -> figure.task + " " + figure.value.text(FORMAT))
        .collect(joining(", ", "-  " + marked(entry) + ", no place without all tasks: ", ""));
  }

  private String marked(BenchmarkEntry entry) {
    return standing(entry).mark(entry.name());
  }

  /** The names of a page's columns. */
  public List<String> columns() {
    return List.copyOf(row("Entry", "", List.of()).keySet());
  }

  /** Returns a row for each entry, by the names of the columns; a missing figure is {@code -}. */
  public List<Map<String, String>> rows() {
    return entries.stream()
        .map(entry -> row(marked(entry), verification(entry), figures(entry)))
        .toList();
  }

  private Map<String, String> row(String name, String verification, List<Figure> figures) {
    Map<String, String> row = new LinkedHashMap<>();
    row.put("Entry", name);
    row.put("Verified by", verification);
    row.put("IQM", text(figures, "", Aggregate.IQM.label()));
    row.put("Mean", text(figures, "", Aggregate.MEAN.label()));
    for (String task : benchmark.names()) {
      row.put(task, text(figures, task, MEAN));
    }
    return row;
  }

  private List<Figure> figures(BenchmarkEntry entry) {
    List<Figure> figures = new ArrayList<>();
    if (hasAllTasks(entry)) {
      Aggregate.estimates(strata(entry))
          .forEach(
              (aggregate, value) ->
                  figures.add(
                      new Figure(entry, verification(entry), "", aggregate.label(), value)));
    }
    for (String task : entry.tasks().keySet()) {
      Estimate mean = Estimate.mean(entry.normalized(benchmark, task));
      figures.add(new Figure(entry, verification(entry), task, MEAN, mean));
    }
    return figures;
  }

  private static String text(List<Figure> figures, String task, String statistic) {
    Stream<Figure> matching =
        figures.stream()
            .filter(figure -> figure.task.equals(task) && figure.statistic.equals(statistic));
    return matching.findFirst().map(figure -> figure.value.text(FORMAT)).orElse("-");
  }
}
