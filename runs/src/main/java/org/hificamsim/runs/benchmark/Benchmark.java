package org.hificamsim.runs.benchmark;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.type.TypeReference;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.data.JsonFault;
import org.hificamsim.runs.RunPlan;

/** The tasks of a file by their names, with their sites. */
public final class Benchmark {
  /** The file, in the folder of the scenarios that come with the simulator. */
  public static final String FILE = "benchmark.json";

  /** The prefix of tasks' names in lists that also have names of scenarios. */
  private static final String PREFIX = "bench/";

  private final Path file;
  private final Catalogue catalogue;
  private final Map<String, BenchmarkTask> tasks;
  private final Map<String, Scenario> sites = new ConcurrentHashMap<>();

  private Benchmark(Path file, Catalogue catalogue, Map<String, BenchmarkTask> tasks) {
    this.file = file;
    this.catalogue = catalogue;
    this.tasks = tasks;
  }

  /** Reads the tasks of a file. */
  public static Benchmark read(Path file, Catalogue catalogue) {
    try {
      Map<String, BenchmarkTask> tasks =
          new ObjectMapper()
              .readValue(
                  file.toFile(), new TypeReference<LinkedHashMap<String, BenchmarkTask>>() {});
      return new Benchmark(file, catalogue, tasks);
    } catch (JsonProcessingException e) {
      throw JsonFault.of(file, e, "tasks");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The names, in order. */
  public List<String> names() {
    return List.copyOf(tasks.keySet());
  }

  /**
   * A task.
   *
   * @param name the name of the task, with or without {@code bench/}
   * @throws InputException when there is no task of this name
   */
  public BenchmarkTask task(String name) {
    BenchmarkTask task = tasks.get(plain(name));
    if (task == null) {
      throw InputException.of("task is '%s', expected one of %s", name, String.join(", ", names()));
    }
    return task;
  }

  /** A task's name without {@code bench/}. */
  public static String plain(String name) {
    return name.startsWith(PREFIX) ? name.substring(PREFIX.length()) : name;
  }

  /** The site of a task as its file describes it. */
  public Scenario site(String name) {
    return sites.computeIfAbsent(
        task(name).scenario(),
        scenario ->
            ScenarioReader.read(
                file.resolveSibling(scenario), catalogue.movements()::knows, warning -> {}));
  }

  /** The site of a task as it is drawn for a seed. */
  public Scenario layout(String name, long seed) {
    return task(name).draw(site(name), seed);
  }

  /** The plan of one episode of a task under a policy. */
  public RunPlan plan(String name, String policy, long seed) {
    return task(name).plan(catalogue, layout(name, seed), policy, seed);
  }

  /** The plan of an episode whose seed is kept apart from those of training and testing. */
  RunPlan freshPlan(String name, String policy, long seed) {
    return task(name).plan(catalogue, task(name).drawFresh(site(name), seed), policy, seed);
  }

  /**
   * Rejects a task whose declaration, scale or site does not match its hash.
   *
   * @param name the name of the task
   */
  void requireUnchanged(String name) {
    String found = task(name).digest(site(name));
    if (!found.equals(task(name).hash())) {
      throw InputException.of(
          "%s: task %s was changed: its hash is %s, expected %s",
          file, name, found, task(name).hash());
    }
  }

  /** Whether a policy is a bound, which plays out of competition; false for an unknown one. */
  public boolean isBound(String policy) {
    String name = policy.split(":", 2)[0];
    return catalogue.policies().knows(name) && catalogue.isBound(name);
  }

  /** The file of the tasks. */
  Path file() {
    return file;
  }

  /** The catalogue of policies, models and movements. */
  public Catalogue catalogue() {
    return catalogue;
  }
}
