package org.hificamsim.bench.plain;

import java.io.BufferedWriter;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.scenario.ScenarioReader;

/** Makes a whole run of the plain objects, from the scenario to its {@code steps.csv}. */
public final class PlainRun {
  private PlainRun() {}

  /** Runs {@code SCENARIO DETECTION POLICY EPSILON STEPS OUT}, with seed 0. */
  public static void main(String[] words) throws IOException {
    Catalogue catalogue = Catalogue.load();
    PlainSimulation simulation =
        new PlainSimulation(
            ScenarioReader.read(
                Path.of(words[0]), catalogue.movements().names()::contains, warning -> {}),
            words[1],
            words[2],
            Double.parseDouble(words[3]),
            0);
    try (BufferedWriter out = Files.newBufferedWriter(Path.of(words[5]))) {
      out.write("run,step,k_min,targets,covered_0,covered_1,covered_k,mean_k,score\n");
      int steps = Integer.parseInt(words[4]);
      for (int step = 0; step < steps; step++) {
        out.write(row(step, simulation.step(), simulation) + "\n");
      }
    }
  }

  private static String row(int step, int kMin, PlainSimulation simulation) {
    int[] covered = simulation.covered();
    int targets = covered[0] + covered[1] + covered[2];
    double meanK = (double) simulation.detections() / targets;
    return "0,"
        + step
        + ","
        + kMin
        + ","
        + targets
        + ","
        + covered[0]
        + ","
        + covered[1]
        + ","
        + covered[2]
        + ","
        + meanK
        + ","
        + (double) kMin;
  }
}
