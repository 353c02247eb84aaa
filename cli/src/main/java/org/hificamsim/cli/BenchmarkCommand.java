package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.LongStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.presentation.report.LeaderboardReport;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.benchmark.Benchmark;
import org.hificamsim.runs.benchmark.BenchmarkEntry;
import org.hificamsim.runs.benchmark.BenchmarkTask;
import org.hificamsim.runs.benchmark.EntryCheck;
import org.hificamsim.runs.benchmark.EntryVerifier;
import org.hificamsim.runs.benchmark.EpisodeLimits;
import org.hificamsim.runs.benchmark.Leaderboard;
import org.hificamsim.runs.benchmark.Verification;
import org.hificamsim.runs.benchmark.VerificationOutcome;
import org.hificamsim.tracks.mate.MateArena;
import org.hificamsim.tracks.mate.MateEpisode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim benchmark}: frozen tasks that others can enter. */
@Command(
    name = "benchmark",
    description = "Plays frozen tasks that anybody can enter, and checks and ranks the results.")
final class BenchmarkCommand {
  private static final String FOLDERS = "Folders of 'benchmark run'.";
  private static final String ARENA = "mate-4v8-9";

  /** The formats of recorded episodes that can be read. */
  enum Format {
    MATE
  }

  @Command(description = "Plays the testing episodes of the tasks, and writes scores and actions.")
  void run(
      @Option(names = "--policy", required = true, paramLabel = "NAME[:key=value,...]")
          String policy,
      @Option(names = "--name", paramLabel = "TEXT") Optional<String> name,
      @Option(names = "--tasks", paramLabel = "A,B") Optional<String> tasks,
      @Option(names = "--out", required = true, paramLabel = "DIR") Path out,
      @Mixin ThreadsOption threads,
      @Mixin Screen screen)
      throws IOException {
    Benchmark benchmark = ShippedScenarios.tasks();
    List<String> taskNames = tasks.map(text -> names(text, benchmark)).orElseGet(benchmark::names);
    int episodes = taskNames.size() * BenchmarkTask.TESTING.size();
    try (OutputFolder folder = screen.folder(out);
        Progress progress = screen.progress("", " episodes", episodes)) {
      BenchmarkEntry entry =
          BenchmarkEntry.play(
              benchmark,
              new BenchmarkEntry.Application(name.orElse(policy), policy, taskNames),
              threads.count(),
              progress,
              folder);
      folder.commit(List.of());
      for (String task : taskNames) {
        screen.say("%-14s %s", task, Estimate.mean(entry.normalized(benchmark, task)).text("%.3f"));
      }
    }
    if (benchmark.isBound(policy)) {
      screen.say("%s is a bound: it plays out of competition and has no rank", policy);
    }
    screen.out().println("files: " + out);
  }

  private static List<String> names(String text, Benchmark benchmark) {
    List<String> names = Arrays.stream(text.split(",", -1)).map(Benchmark::plain).toList();
    names.forEach(benchmark::task);
    NameLists.requireDistinct("--tasks", names);
    return names;
  }

  @Command(
      description = "Plays the recorded actions of entries again; refuses what scores otherwise.")
  void check(
      @Parameters(arity = "1..*", paramLabel = "DIR", description = FOLDERS) List<Path> folders,
      @Mixin ThreadsOption threads,
      @Mixin Screen screen) {
    EntryCheck check = new EntryCheck(ShippedScenarios.tasks(), threads.count());
    for (Path folder : folders) {
      BenchmarkEntry entry = check.check(folder);
      String tasks = Texts.counted(entry.tasks().size(), "task");
      screen.say("%s: %s, %s, agrees", folder, entry.name(), tasks);
    }
  }

  @Command(
      description = {
        "Plays the policy of an entry on fresh seeds, which the secret draws, and says whether",
        "the scores of the entry hold."
      })
  int verify(
      @Parameters(paramLabel = "DIR", description = "Folder of 'benchmark run'.") Path path,
      @Option(
              names = "--secret",
              required = true,
              paramLabel = "TEXT",
              arity = "0..1",
              interactive = true,
              prompt = "secret: ")
          String secret,
      @Option(names = "--episodes", paramLabel = "N") int episodes,
      @Option(names = "--seconds", paramLabel = "S") int seconds,
      @Option(names = "--memory", paramLabel = "MB") int memory,
      @Option(names = "--out", required = true, paramLabel = "DIR") Path out,
      @Mixin ThreadsOption threads,
      @Mixin Screen screen)
      throws IOException {
    Numbers.inRange("--episodes", episodes, 2, 1_000);
    Numbers.inRange("--seconds", seconds, 1, 86_400);
    Numbers.inRange("--memory", memory, 512, 1_000_000);
    Benchmark benchmark = ShippedScenarios.tasks();
    EpisodeLimits limits = new EpisodeLimits(seconds, memory);
    EntryVerifier verifier =
        new EntryVerifier(benchmark, secret, episodes, limits, threads.count());
    BenchmarkEntry entry = new EntryCheck(benchmark, threads.count()).check(path);
    try (OutputFolder folder = screen.folder(out);
        Progress progress = screen.progress("", " episodes", verifier.episodes(entry))) {
      Verification verification = verifier.verify(entry, path, progress);
      verification.write(folder);
      folder.commit(List.of());
      verification.tasks().forEach((task, finding) -> screen.say("%-14s %s", task, finding.text()));
      screen.say("%-14s %s", "all", verification.all().text());
      screen.say("%s", verification.holds() ? "verified" : "NOT verified");
      if (!verification.confined()) {
        screen.note(
            "this system has no namespaces for users: the policy could read files and see"
                + " processes");
      }
      screen.out().println("files: " + out);
      return verification.holds() ? 0 : 1;
    }
  }

  @Command(description = "Checks entries, and writes a page of them.")
  void leaderboard(
      @Parameters(arity = "1..*", paramLabel = "DIR", description = FOLDERS) List<Path> folders,
      @Option(names = "--verified", paramLabel = "DIR", arity = "1") List<Path> verified,
      @Option(names = "--out", required = true, paramLabel = "DIR") Path out,
      @Mixin ThreadsOption threads,
      @Mixin Screen screen)
      throws IOException {
    Benchmark benchmark = ShippedScenarios.tasks();
    EntryCheck check = new EntryCheck(benchmark, threads.count());
    List<Verification> verifications =
        verified == null ? List.of() : verified.stream().map(Verification::read).toList();
    Map<BenchmarkEntry, VerificationOutcome> outcomes = new HashMap<>();
    List<BenchmarkEntry> entries = new ArrayList<>();
    for (Path folder : folders) {
      BenchmarkEntry entry = check.check(folder);
      entries.add(entry);
      verifications.stream()
          .filter(verification -> verification.isOf(folder))
          .forEach(
              verification ->
                  outcomes.merge(entry, verification.outcome(), VerificationOutcome::worse));
    }
    Leaderboard board = new Leaderboard(benchmark, entries, outcomes);
    try (OutputFolder folder = screen.folder(out)) {
      board.write(folder);
      folder.write("leaderboard.html", LeaderboardReport.page(board).html());
      folder.commit(List.of());
    }
    board.lines().forEach(screen.out()::println);
    screen.out().println("files: " + out);
  }

  @Command(
      description = {
        "Prints the share of the targets that the cameras of a recorded episode cover.",
        "The poses are those of the recording; lines of sight are computed by this simulator."
      })
  @SuppressWarnings("UnusedVariable") // picocli refuses any other format
  void replay(
      @Parameters(paramLabel = "EPISODE.csv[.gz]", description = "The poses of each step.")
          Path episode,
      @Option(names = "--format", required = true, paramLabel = "mate") Format format,
      @Mixin Screen screen) {
    MateEpisode replayed = MateEpisode.replay(episode);
    screen.say(
        "episode  %s: %d steps, %d cameras, %d targets",
        episode, replayed.steps(), replayed.cameras(), replayed.targets());
    screen.say("coverage %.4f", replayed.coverage());
  }

  @Command(description = "Plays MATE's arena: its greedy cameras against its greedy targets.")
  void arena(
      @Option(names = "--episodes", paramLabel = "N") int episodes,
      @Option(names = "--seed", paramLabel = "S") int seed,
      @Mixin Screen screen) {
    Numbers.inRange("--episodes", episodes, 1, 1_000_000);
    Scenario site = ShippedScenarios.read(List.of(ARENA), Catalogue.load()).get(ARENA);
    MateArena[] played =
        LongStream.range(seed, (long) seed + episodes)
            .mapToObj(arenaSeed -> MateArena.play(site, arenaSeed))
            .toArray(MateArena[]::new);
    screen.say("coverage  %s", mean(played, MateArena::coverage, "%.3f"));
    screen.say("transport %s", mean(played, MateArena::transported, "%.3f"));
    screen.say("steps     %s", mean(played, MateArena::steps, "%.0f"));
    long steps = Arrays.stream(played).mapToLong(MateArena::steps).sum();
    ProcessHandle.current() // the processor time of all threads since Java started
        .info()
        .totalCpuDuration()
        .ifPresent(
            duration ->
                screen.note(
                    "%.0f steps a second of processor time", 1e3 * steps / duration.toMillis()));
  }

  private static String mean(MateArena[] played, ToDoubleFunction<MateArena> figure, String form) {
    return Estimate.mean(Arrays.stream(played).mapToDouble(figure).toArray()).text(form);
  }
}
