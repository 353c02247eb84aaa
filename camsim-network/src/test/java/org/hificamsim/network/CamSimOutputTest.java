package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.CamSimCommand;
import org.hificamsim.core.Reference;
import org.hificamsim.network.statistics.StepFigures;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares each column with the output of CamSim, for our scenarios and its own. */
class CamSimOutputTest {
  private static final double ABSOLUTE = 1e-9;
  private static final double RELATIVE = 1e-9;

  /**
   * One line of an index of recorded outputs.
   *
   * @param comparableSteps the number of steps that are the same in every run of CamSim
   */
  record Recorded(String file, RecordedRun run, int comparableSteps) {
    static Recorded ours(String[] cells) {
      CamSimCommand command = CamSimCommand.of("own-camsim/" + cells[0], cells[1]);
      return new Recorded("own-camsim/" + cells[2], new RecordedRun(command), command.steps());
    }

    static Recorded camSims(String[] cells) {
      CamSimCommand command = CamSimCommand.of("camsim/scenarios/" + cells[1], cells[2]);
      String[] words = cells[5].split(" ");
      int steps = words.length == 1 ? command.steps() : Integer.parseInt(words[words.length - 1]);
      return new Recorded("camsim/outputs/" + cells[0], new RecordedRun(command), steps);
    }

    boolean isStable() {
      return comparableSteps == run.command().steps();
    }

    @Override
    public String toString() {
      return file;
    }
  }

  static Stream<Recorded> ours() {
    List<String[]> index = Reference.rows("own-camsim/index.csv");
    assertEquals(26, index.size());
    return index.stream().map(Recorded::ours);
  }

  static Stream<Recorded> camSims() {
    List<Recorded> index =
        Reference.rows("camsim/outputs/index.csv").stream().map(Recorded::camSims).toList();
    assertEquals(29, index.size());
    assertEquals(28, index.stream().filter(Recorded::isStable).count());
    return index.stream();
  }

  @ParameterizedTest
  @MethodSource("ours")
  void columnsOfOurScenariosEqualRecording(Recorded output) throws IOException {
    assertColumns(output);
  }

  @ParameterizedTest
  @MethodSource("camSims")
  void columnsAndHandoversOfCamSimScenariosEqualRecording(Recorded output) throws IOException {
    long handovers = assertColumns(output).stream().mapToLong(StepFigures::handovers).sum();
    if (output.isStable()) {
      String[] summary = Reference.rows(output.file().replace(".csv", ".summary.csv")).get(0);
      assertEquals(Double.parseDouble(summary[7]), (double) handovers);
    }
  }

  private static List<StepFigures> assertColumns(Recorded output) throws IOException {
    List<String> lines = Files.readAllLines(Reference.file(output.file()));
    assertEquals(
        "time;utility;communication;visible;strategy;totUtil;totComm;overlap;confidence;proportion",
        lines.get(0));
    List<StepFigures> ours = new ArrayList<>();
    output.run().run((world, network) -> ours.add(network.figures()));
    assertEquals(lines.size() - 1, ours.size());
    for (int step = 0; step < output.comparableSteps(); step++) {
      assertRow(lines.get(step + 1), ours.get(step));
    }
    assertTrue(output.comparableSteps() >= 120, output.comparableSteps() + " steps compared");
    return ours;
  }

  private static void assertRow(String line, StepFigures ours) {
    double[] recorded = Stream.of(line.split(";")).mapToDouble(Double::parseDouble).toArray();
    assertEquals(recorded[0], (double) ours.step());
    String step = "step " + ours.step() + " ";
    assertEquals(recorded[1], ours.utility(), ABSOLUTE, step + "utility");
    assertEquals(recorded[2], (double) ours.communication(), step + "communication");
    assertEquals(0, recorded[3], step + "visible");
    assertEquals(recorded[4], ours.strategyChanges(), step + "strategy");
    assertEquals(recorded[5], ours.banditUtility(), ABSOLUTE, step + "totUtil");
    assertEquals(recorded[6], (double) ours.attempts(), step + "totComm");
    assertEquals(recorded[7], ours.overlap(), RELATIVE * recorded[7], step + "overlap");
    assertEquals(recorded[8], ours.confidence(), ABSOLUTE, step + "confidence");
    assertEquals(recorded[9], ours.proportion(), ABSOLUTE, step + "proportion");
  }
}
