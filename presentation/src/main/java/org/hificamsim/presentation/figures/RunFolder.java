package org.hificamsim.presentation.figures;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.hificamsim.core.InputException;

/**
 * What {@code hificamsim run} left in a folder, as far as it is drawn.
 *
 * @param means k_min by step, the mean over the repeats
 */
public record RunFolder(
    String scenario, String detection, String policy, int repeats, double[] means) {
  private static final int MOST_STEPS = 10_000_000;

  /**
   * Reads {@code summary.json} and {@code steps.csv}.
   *
   * @throws InputException when one is missing or is not what a run writes
   */
  public static RunFolder read(Path folder) throws IOException {
    JsonNode summary = summary(folder.resolve("summary.json"));
    int repeats = summary.path("repeat").asInt();
    int steps = summary.path("steps").asInt();
    if (repeats < 1 || steps < 1 || steps > MOST_STEPS) {
      throw new InputException(
          folder.resolve("summary.json")
              + ": steps is "
              + steps
              + " and repeat is "
              + repeats
              + ", expected what 'hificamsim run' writes");
    }
    return new RunFolder(
        summary.path("scenario").asText(),
        summary.path("detection").asText(),
        summary.path("policy").asText(),
        repeats,
        means(folder.resolve("steps.csv"), steps, repeats));
  }

  private static JsonNode summary(Path file) throws IOException {
    require(file);
    try {
      return new ObjectMapper().readTree(file.toFile());
    } catch (JsonProcessingException e) {
      throw new InputException(
          "%s:%d:%d: not JSON, expected what 'hificamsim run' writes"
              .formatted(file, e.getLocation().getLineNr(), e.getLocation().getColumnNr()),
          e);
    }
  }

  private static double[] means(Path file, int steps, int repeats) throws IOException {
    require(file);
    long[] sums = new long[steps];
    try (BufferedReader reader = Files.newBufferedReader(file)) {
      String line = reader.readLine();
      for (int number = 2; (line = reader.readLine()) != null; number++) {
        add(sums, line, file, number);
      }
    }
    return Arrays.stream(sums).mapToDouble(sum -> sum / (double) repeats).toArray();
  }

  private static void add(long[] sums, String line, Path file, int number) {
    String[] fields = line.split(",", -1);
    try {
      sums[Integer.parseInt(fields[1])] += Long.parseLong(fields[2]);
    } catch (NumberFormatException | ArrayIndexOutOfBoundsException e) {
      throw new InputException(
          "%s:%d:1: '%s' is no row of run,step,k_min,... with a step below %d"
              .formatted(file, number, line, sums.length),
          e);
    }
  }

  private static void require(Path file) {
    if (!Files.isRegularFile(file)) {
      throw new InputException(
          "no file '" + file + "', expected a folder that 'hificamsim run' wrote");
    }
  }
}
