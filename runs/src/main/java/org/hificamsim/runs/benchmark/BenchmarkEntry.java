package org.hificamsim.runs.benchmark;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.StreamReadFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
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
import org.hificamsim.data.JsonFault;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.RunProgress;
import org.hificamsim.runs.output.JsonOutput;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.PolicyFiles;

/**
 * The results of a policy in the benchmark: a folder of {@value #FILE} and a file of {@linkplain
 * RecordedActions actions} for each task.
 *
 * @param version the version of the simulator
 * @param name the name on the leaderboard
 * @param policy the policy with its options
 * @param files the SHA-256 of each file that the policy reads, by file name
 * @param tasks the results by the names of the tasks
 */
public record BenchmarkEntry(
    String version,
    String name,
    String policy,
    Map<String, String> files,
    Map<String, TaskScores> tasks) {
  public static final String FILE = "entry.json";

  private static final String PLAYED = "played";
  private static final String SEED = "{seed}";
  private static final int MAX_POLICY = 2_000;
  private static final long MAX_BYTES = 1 << 20;
  private static final ObjectMapper MAPPER =
      JsonMapper.builder().enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).build();

  /**
   * The results in a task.
   *
   * @param task the hash of the task
   * @param actions the SHA-256 of the file of actions
   * @param seeds the seeds of the episodes
   * @param scores the scores of the episodes, each the mean of its steps
   */
  public record TaskScores(String task, String actions, List<Long> seeds, List<Double> scores) {
    /** Rejects missing values. */
    public TaskScores {
      requireAll("task, actions, seeds, scores", task, actions, seeds, scores);
      requireAll("a number for each seed", seeds.toArray());
      requireAll("a number for each score", scores.toArray());
    }
  }

  /** Rejects missing values, and texts that could forge lines of output. */
  public BenchmarkEntry {
    requireAll("version, name, policy, files, tasks", version, name, policy, files, tasks);
    requireAll("a result of each task", tasks.values().toArray());
    requireAll("the SHA-256 of each file", files.values().toArray());
    EntryName.require(name);
    EntryName.requireVisible("policy", policy);
    requireOnePolicy(policy);
    if (policy.length() > MAX_POLICY) {
      throw InputException.of(
          "policy has %s characters, expected at most %s", policy.length(), MAX_POLICY);
    }
    files.keySet().forEach(file -> EntryName.requireVisible("file", file));
  }

  private static void requireAll(String names, Object... values) {
    if (Stream.of(values).anyMatch(value -> value == null)) {
      throw new InputException("something is missing, expected " + names);
    }
  }

  /**
   * A policy that is to be entered.
   *
   * @param name the name on the leaderboard
   * @param policy the policy with its options; {@code {task}} stands for the task of an episode,
   *     and {@code {seed}} for its seed if recorded actions are played
   * @param tasks the names of the tasks that it plays
   */
  public record Application(String name, String policy, List<String> tasks) {
    /** Rejects a name that cannot be shown, and a policy that knows the seeds. */
    public Application {
      EntryName.require(name);
      requireOnePolicy(policy);
    }
  }

  private static void requireOnePolicy(String policy) {
    if (policy.contains(SEED) && !isPlayed(policy)) {
      throw InputException.of(
          "policy %s has %s, expected one policy for all episodes of a task", policy, SEED);
    }
  }

  /**
   * Plays the testing episodes of an application, and adds the entry to a folder's files.
   *
   * @param threads the number of threads that share the episodes, 1 or more
   */
  public static BenchmarkEntry play(
      Benchmark benchmark,
      Application application,
      int threads,
      RunProgress progress,
      OutputFolder folder)
      throws IOException {
    List<String> tasks = application.tasks();
    tasks.forEach(benchmark::requireUnchanged);
    List<RunPlan> plans = plans(benchmark, application);
    Map<String, byte[]> copies = new TreeMap<>();
    Map<String, String> files = files(plans, copies);
    for (Map.Entry<String, byte[]> copy : copies.entrySet()) {
      folder.write(copy.getKey(), copy.getValue());
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
    int episodesPerTask = BenchmarkTask.TESTING.size();
    for (int i = 0; i < tasks.size(); i++) {
      String task = tasks.get(i);
      List<Episode> played = episodes.subList(i * episodesPerTask, (i + 1) * episodesPerTask);
      RecordedActions.write(folder, task, benchmark, played);
      String actions = folder.hashes().get(RecordedActions.file(task));
      scores.put(task, scores(benchmark.task(task), actions, played));
    }
    BenchmarkEntry entry =
        new BenchmarkEntry(
            ManifestFile.version(),
            application.name(),
            withoutFolders(application, files),
            files,
            scores);
    JsonOutput.write(folder, FILE, MAPPER.valueToTree(entry));
    return entry;
  }

  private static List<RunPlan> plans(Benchmark benchmark, Application application) {
    List<RunPlan> plans = new ArrayList<>();
    for (String task : application.tasks()) {
      for (long seed : BenchmarkTask.TESTING) {
        String policy =
            application.policy().replace("{task}", task).replace(SEED, Long.toString(seed));
        if (benchmark.catalogue().policies().create(policy).jumps()) {
          throw InputException.of("policy %s moves cameras in no time, expected another", policy);
        }
        plans.add(benchmark.plan(task, policy, seed));
      }
    }
    return plans;
  }

  /** Returns the policy without the folders of its files, since the entry has all files. */
  private static String withoutFolders(Application application, Map<String, String> files) {
    String policy = application.policy();
    return isPlayed(policy)
        ? PLAYED
        : EnteredPolicy.replaceFiles(policy, application.tasks(), files.keySet(), name -> name);
  }

  /** Whether a policy plays recorded actions. */
  static boolean isPlayed(String policy) {
    return policy.split(":", 2)[0].equals(PLAYED);
  }

  private static TaskScores scores(BenchmarkTask task, String actions, List<Episode> episodes) {
    List<Double> scores = episodes.stream().map(Episode::score).toList();
    return new TaskScores(task.hash(), actions, BenchmarkTask.TESTING, scores);
  }

  /** The scores of a task's episodes on a scale from 0, zoom-out, to 1, the best possible score. */
  public double[] normalized(Benchmark benchmark, String task) {
    List<Double> scores = tasks.get(task).scores();
    return IntStream.range(0, scores.size())
        .mapToDouble(episode -> benchmark.task(task).normalized(episode, scores.get(episode)))
        .toArray();
  }

  /**
   * Returns the hashes of the files of policies.
   *
   * @param copies receives the files, by their names in the entry's folder
   */
  private static Map<String, String> files(List<RunPlan> plans, Map<String, byte[]> copies) {
    PolicyFiles files = new PolicyFiles();
    Map<String, String> hashes = new TreeMap<>();
    plans.stream()
        .map(RunPlan::policy)
        .distinct()
        .filter(policy -> !isPlayed(policy))
        .flatMap(policy -> files.of(policy).stream())
        .distinct()
        .forEach(file -> add(hashes, copies, file));
    return hashes;
  }

  private static void add(Map<String, String> hashes, Map<String, byte[]> copies, Path file) {
    String name = file.getFileName().toString();
    byte[] content = PolicyFiles.content(file);
    String hash = Sha256.of(content);
    if (!hash.equals(hashes.getOrDefault(name, hash))) {
      throw InputException.of(
          "the policy has two files '%s', expected files of different names", name);
    }
    hashes.put(name, hash);
    copies.put(EnteredPolicy.PREFIX + name, content);
  }

  /**
   * Reads an entry.
   *
   * @param path the path of its {@value #FILE}
   * @throws InputException when the file is not an entry
   */
  static BenchmarkEntry read(Path path) {
    requireRegular(path);
    try {
      if (Files.size(path) > MAX_BYTES) {
        throw InputException.of("%s has more than %s bytes, expected an entry", path, MAX_BYTES);
      }
      return MAPPER.readValue(path.toFile(), BenchmarkEntry.class);
    } catch (JsonProcessingException e) {
      throw JsonFault.of(path, e, "what 'benchmark run' writes");
    } catch (IOException e) {
      throw new InputException(path + " cannot be read, expected what 'benchmark run' writes", e);
    }
  }

  /**
   * Rejects links and folders, since an entry consists of the files in its folder. A missing file
   * passes: its reader reports it.
   */
  static void requireRegular(Path file) {
    if (Files.exists(file, LinkOption.NOFOLLOW_LINKS)
        && !Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)) {
      throw InputException.of("%s is a link or no file, expected a regular file", file);
    }
  }

  /** The file of an entry, given the file itself or its folder. */
  static Path file(Path path) {
    return Files.isDirectory(path) ? path.resolve(FILE) : path;
  }
}
