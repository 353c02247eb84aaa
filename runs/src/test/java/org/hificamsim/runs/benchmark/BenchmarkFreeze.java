package org.hificamsim.runs.benchmark;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;

/**
 * Computes the scale and the hash of tasks that have none, and writes them into their file. Tasks
 * that have them stay as they are, since a changed task needs a new name.
 */
final class BenchmarkFreeze {
  private BenchmarkFreeze() {}

  /** Freezes the tasks of the file that is the only argument. */
  public static void main(String[] args) throws IOException {
    Path file = Path.of(args[0]);
    Benchmark benchmark = Benchmark.read(file, Catalogue.load());
    ObjectMapper mapper = new ObjectMapper();
    ObjectNode all = (ObjectNode) mapper.readTree(file.toFile());
    for (String name : benchmark.names()) {
      ObjectNode task = (ObjectNode) all.get(name);
      if (task.get("hash").asText().isEmpty()) {
        if (task.get("best").isEmpty()) {
          scale(benchmark, name, task);
        }
        BenchmarkTask frozen = mapper.treeToValue(task, BenchmarkTask.class);
        task.put("hash", frozen.digest(benchmark.site(name)));
      }
    }
    Files.writeString(file, mapper.writerWithDefaultPrettyPrinter().writeValueAsString(all) + "\n");
  }

  private static void scale(Benchmark benchmark, String name, ObjectNode task) {
    ArrayNode zero = task.putArray("zoomOut");
    ArrayNode best = task.putArray("best");
    ArrayNode proven = task.putArray("proven");
    RunExecutor executor = new RunExecutor(benchmark.catalogue());
    for (long seed : BenchmarkTask.TESTING) {
      RunPlan plan = benchmark.plan(name, "optimal", seed);
      zero.add(Episode.play(benchmark, plan.withPolicy("zoom-out")).score());
      RunResult result = executor.repeat(plan, 0, List.of());
      best.add(result.bound() / plan.steps());
      proven.add(result.proof().orElseThrow().unprovenSteps() == 0);
      System.out.println(
          name
              + " "
              + seed
              + " "
              + zero.get(zero.size() - 1)
              + " "
              + best.get(best.size() - 1)
              + " "
              + proven.get(proven.size() - 1));
    }
  }
}
