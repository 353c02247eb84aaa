package org.hificamsim.runs.benchmark;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.core.policy.OraclePolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.runs.output.PolicyFiles;

/** The policy of an entry, with the files that lie in the entry's folder. */
final class EnteredPolicy {
  /** The prefix of the copies of a policy's files. */
  static final String PREFIX = "policy-";

  private static final String TASK = "{task}";
  private static final String PART_BOUNDARY = "(?<=[:,=])|(?=[:,=])";

  private final Path folder;
  private final BenchmarkEntry entry;

  /**
   * @param folder the folder of the entry
   * @throws InputException if the entry has no policy that can be played, or a file was changed
   */
  EnteredPolicy(Benchmark benchmark, Path folder, BenchmarkEntry entry) {
    this.folder = folder;
    this.entry = entry;
    if (BenchmarkEntry.isPlayed(entry.policy())) {
      throw InputException.of(
          "%s has a list of actions, expected a policy: onnx:FILE, python:FILE or one by its name",
          folder);
    }
    if (benchmark.isBound(entry.policy())) {
      throw InputException.of(
          "%s: %s is a bound, expected a policy that cameras can run", folder, entry.policy());
    }
    requireUnchangedFiles(BenchmarkEntry.file(folder), entry);
    entry.tasks().keySet().forEach(task -> requirePlayable(benchmark, forTask(task)));
  }

  /** Rejects a policy that no camera can run, or that reads files outside the entry's folder. */
  private void requirePlayable(Benchmark benchmark, String policy) {
    ZoomPolicy instance = benchmark.catalogue().policies().create(policy);
    if (instance instanceof OraclePolicy || instance.jumps()) {
      throw InputException.of("%s: %s, expected a policy that cameras can run", folder, policy);
    }
    for (Path file : new PolicyFiles().of(policy)) {
      if (!entry.files().keySet().stream().map(this::copy).toList().contains(file.toString())) {
        throw InputException.of(
            "%s: policy %s reads %s, expected files of the entry alone", folder, policy, file);
      }
    }
  }

  /**
   * Rejects an entry whose policy files are not those that it was recorded with.
   *
   * @param entryFile the file of the entry, in whose folder they are
   */
  static void requireUnchangedFiles(Path entryFile, BenchmarkEntry entry) {
    entry.files().forEach((name, hash) -> requireUnchanged(entryFile, name, hash));
  }

  private static void requireUnchanged(Path entryFile, String name, String hash) {
    Path file = entryFile.resolveSibling(PREFIX + name);
    BenchmarkEntry.requireRegular(file);
    if (name.contains("/") || name.contains("\\") || !Files.isRegularFile(file)) {
      throw InputException.of("%s: no such file, expected the policy's", file);
    }
    String found = Io.get(() -> Sha256.of(file));
    if (!found.equals(hash)) {
      throw InputException.of("%s: SHA-256 %s, expected %s", file, found, hash);
    }
  }

  /** The policy for a task, with its options. */
  String forTask(String task) {
    return replaceFiles(
        entry.policy().replace(TASK, task), List.of(task), entry.files().keySet(), this::copy);
  }

  /**
   * Replaces the paths of files in the options of a policy.
   *
   * @param tasks the tasks whose names may occur in paths
   * @param files the names of the files
   * @param replacement returns the replacement of a file's path, given the file's name
   */
  static String replaceFiles(
      String policy, List<String> tasks, Set<String> files, UnaryOperator<String> replacement) {
    return Arrays.stream(policy.split(PART_BOUNDARY))
        .map(
            part ->
                tasks.stream().anyMatch(task -> files.contains(name(part.replace(TASK, task))))
                    ? replacement.apply(name(part))
                    : part)
        .collect(Collectors.joining());
  }

  private String copy(String name) {
    return folder.resolve(PREFIX + name).toString();
  }

  private static String name(String path) {
    return path.substring(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);
  }
}
