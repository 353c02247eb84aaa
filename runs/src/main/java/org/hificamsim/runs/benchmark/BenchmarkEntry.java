package org.hificamsim.runs.benchmark;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.RunProgress;
import org.hificamsim.runs.output.JsonOutput;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.PolicyFiles;

/**
 * What somebody's policy has reached: a folder of {@value #FILE} and a file of {@linkplain
 * RecordedActions actions} for each task.
 *
 * @param version of the simulator
 * @param name that stands on the page
 * @param policy with its options
 * @param files the SHA-256 of each file that the policy decides by
 * @param tasks results, by the task's name
 */
public record BenchmarkEntry(
    String version,
    String name,
    String policy,
    Map<String, String> files,
    Map<String, TaskScores> tasks) {
  public static final String FILE = "entry.json";

  private static final String PLAYED = "played";
  private static final ObjectMapper MAPPER = new ObjectMapper();

  /**
   * What was reached in a task.
   *
   * @param task its hash
   * @param actions the SHA-256 of the file of actions
   * @param seeds of the episodes
   * @param scores of each episode, mean of a step
   */
  public record TaskScores(String task, String actions, List<Long> seeds, List<Double> scores) {
    /** Refuses what is incomplete. */
    public TaskScores {
      requireAll("task, actions, seeds, scores", task, actions, seeds, scores);
    }
  }

  /** Refuses what is incomplete. */
  public BenchmarkEntry {
    requireAll("version, name, policy, files, tasks", version, name, policy, files, tasks);
  }

  private static void requireAll(String names, Object... values) {
    if (Stream.of(values).anyMatch(value -> value == null)) {
      throw new InputException("something is missing, expected " + names);
    }
  }

  /**
   * Plays the testing episodes of tasks, and adds what came out to a folder's files.
   *
   * @param policy in which {task} and {seed} stand for those of an episode
   */
  public static BenchmarkEntry play(
      Benchmark benchmark,
      String name,
      String policy,
      List<String> tasks,
      int threads,
      RunProgress progress,
      OutputFolder folder)
      throws IOException {
    List<RunPlan> plans = new ArrayList<>();
    for (String task : tasks) {
      for (long seed : BenchmarkTask.TESTING) {
        String own = policy.replace("{task}", task).replace("{seed}", Long.toString(seed));
        if (benchmark.catalogue().policies().create(own).jumps()) {
          throw InputException.of("policy %s moves cameras in no time, expected another", own);
        }
        plans.add(benchmark.plan(task, own, seed));
      }
    }
    List<Episode> episodes =
        Parallel.map(
            plans,
            threads,
            plan -> {
              Episode episode = Episode.play(benchmark, plan);
              progress.advance();
              return episode;
            });
    Map<String, TaskScores> scores = new LinkedHashMap<>();
    int each = BenchmarkTask.TESTING.size();
    for (int i = 0; i < tasks.size(); i++) {
      List<Episode> of = episodes.subList(i * each, (i + 1) * each);
      RecordedActions.write(folder, tasks.get(i), benchmark, of);
      String actions = folder.hashes().get(RecordedActions.file(tasks.get(i)));
      scores.put(tasks.get(i), scores(benchmark.task(tasks.get(i)), actions, of));
    }
    BenchmarkEntry entry =
        new BenchmarkEntry(ManifestFile.version(), name, shown(policy), files(plans), scores);
    JsonOutput.write(folder, FILE, MAPPER.valueToTree(entry));
    return entry;
  }

  /** Without the path of actions that are played: they are those of the entry. */
  private static String shown(String policy) {
    return policy.startsWith(PLAYED) ? PLAYED : policy;
  }

  private static TaskScores scores(BenchmarkTask task, String actions, List<Episode> episodes) {
    List<Double> scores = episodes.stream().map(Episode::score).toList();
    return new TaskScores(task.hash(), actions, BenchmarkTask.TESTING, scores);
  }

  /** The scores of a task's episodes between 0, zoom-out, and 1, the best that is possible. */
  public double[] normalized(Benchmark benchmark, String task) {
    List<Double> of = tasks.get(task).scores();
    return IntStream.range(0, of.size())
        .mapToDouble(i -> benchmark.task(task).normalized(i, of.get(i)))
        .toArray();
  }

  private static Map<String, String> files(List<RunPlan> plans) {
    PolicyFiles files = new PolicyFiles();
    Map<String, String> hashes = new TreeMap<>();
    plans.stream()
        .map(RunPlan::policy)
        .distinct()
        .filter(policy -> !policy.startsWith(PLAYED))
        .flatMap(policy -> files.of(policy).stream())
        .forEach(
            file ->
                hashes.put(file.getFileName().toString(), Sha256.of(PolicyFiles.content(file))));
    return hashes;
  }

  /**
   * Reads one that was written before.
   *
   * @param path of the folder or of its {@value #FILE}
   * @throws InputException when it is none
   */
  static BenchmarkEntry read(Path path) {
    try {
      return MAPPER.readValue(path.toFile(), BenchmarkEntry.class);
    } catch (JsonProcessingException e) {
      String fault = e.getOriginalMessage().lines().findFirst().orElse("");
      throw new InputException(path + ": " + fault + ", expected what 'benchmark run' writes", e);
    } catch (IOException e) {
      throw new InputException(path + " cannot be read, expected what 'benchmark run' writes", e);
    }
  }

  /** The file of an entry that is given by its folder, or by the file. */
  static Path file(Path path) {
    return Files.isDirectory(path) ? path.resolve(FILE) : path;
  }
}
