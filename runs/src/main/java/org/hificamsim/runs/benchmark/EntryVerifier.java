package org.hificamsim.runs.benchmark;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.core.program.Sandbox;
import org.hificamsim.runs.benchmark.Verification.Finding;
import org.hificamsim.runs.compare.RunProgress;

/**
 * Verifies entries: checks their actions, then plays their policies again, in the testing episodes
 * and in fresh ones that nobody could prepare for.
 */
public final class EntryVerifier {
  /** The probability that chance alone makes an honest entry fail. */
  private static final double ALPHA = 0.05;

  private final Benchmark benchmark;
  private final FreshSeeds seeds;
  private final int episodes;
  private final EpisodeLimits limits;
  private final int threads;

  /**
   * @param secret the secret from which fresh seeds are drawn
   * @param episodes the number of fresh episodes of each task, 2 or more
   * @param limits the limits of what a policy may take
   * @param threads the number of threads that share the tasks, 1 or more
   */
  public EntryVerifier(
      Benchmark benchmark, String secret, int episodes, EpisodeLimits limits, int threads) {
    this.benchmark = benchmark;
    seeds = new FreshSeeds(secret);
    this.episodes = episodes;
    this.limits = limits;
    this.threads = threads;
  }

  /** The number of episodes that the verification of an entry plays. */
  public int episodes(BenchmarkEntry entry) {
    return entry.tasks().size() * (episodes + BenchmarkTask.TESTING.size());
  }

  /**
   * Verifies an entry whose actions were checked.
   *
   * @param path the path of its folder or file
   */
  public Verification verify(BenchmarkEntry entry, Path path, RunProgress progress) {
    Path file = BenchmarkEntry.file(path);
    Path folder = file.toAbsolutePath().getParent();
    EnteredPolicy policy = new EnteredPolicy(benchmark, folder, entry);
    List<String> tasks = List.copyOf(entry.tasks().keySet());
    List<List<Double>> scores =
        Parallel.map(
            tasks, threads, task -> scores(folder, trials(task, policy.forTask(task)), progress));
    return verification(entry, Io.get(() -> Sha256.of(file)), scores);
  }

  private List<Double> scores(Path folder, List<Trial> trials, RunProgress progress) {
    List<Double> scores = new ArrayList<>();
    try (EpisodeProgram program = new EpisodeProgram(benchmark, limits, trials.size(), folder)) {
      for (Trial trial : trials) {
        scores.add(program.play(trial).score());
        progress.advance();
      }
    }
    return scores;
  }

  /** The testing episodes of a task, then the fresh ones. */
  private List<Trial> trials(String task, String policy) {
    List<Trial> trials = new ArrayList<>();
    BenchmarkTask.TESTING.forEach(seed -> trials.add(new Trial(task, policy, seed, false)));
    seeds.draw(task, episodes).forEach(seed -> trials.add(new Trial(task, policy, seed, true)));
    return trials;
  }

  private Verification verification(BenchmarkEntry entry, String hash, List<List<Double>> scores) {
    Map<String, Finding> findings = new LinkedHashMap<>();
    List<Claim> claims = new ArrayList<>();
    double alpha = ALPHA / entry.tasks().size();
    int testing = BenchmarkTask.TESTING.size();
    Iterator<List<Double>> taskScores = scores.iterator();
    for (String task : entry.tasks().keySet()) {
      List<Double> played = taskScores.next();
      double[] claimed = scaled(task, entry.tasks().get(task).scores());
      double[] fresh = scaled(task, played.subList(testing, played.size()));
      Claim claim = Claim.of(claimed, fresh);
      boolean reproduced = entry.tasks().get(task).scores().equals(played.subList(0, testing));
      claims.add(claim);
      findings.put(task, finding(claim, StatUtils.mean(fresh), alpha, reproduced));
    }
    double fresh = findings.values().stream().mapToDouble(Finding::fresh).average().orElse(0);
    boolean reproduced = findings.values().stream().allMatch(Finding::reproduced);
    return new Verification(
        hash,
        seeds.hash(),
        Sandbox.confines(),
        findings,
        finding(Claim.mean(claims), fresh, ALPHA, reproduced));
  }

  private static Finding finding(Claim claim, double fresh, double alpha, boolean reproduced) {
    return new Finding(fresh + claim.difference(), fresh, claim.margin(alpha), reproduced);
  }

  private double[] scaled(String task, List<Double> scores) {
    return scores.stream().mapToDouble(benchmark.task(task)::scaled).toArray();
  }
}
