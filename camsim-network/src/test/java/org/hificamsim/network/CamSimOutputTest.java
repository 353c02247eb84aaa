package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.Reference;
import org.hificamsim.network.statistics.StepFigures;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** CamSim's recorded outputs, column by column, and the handovers of its summaries. */
class CamSimOutputTest {
  private static final String FOLDER = "camsim/outputs/";
  private static final double ABSOLUTE = 1e-9;
  private static final double RELATIVE = 1e-9;

  /** One line of the index of recorded outputs. */
  record Recorded(String file, RecordedRun run, String hashOrder) {
    static Recorded of(String line) {
      String[] cells = line.split(",");
      return new Recorded(cells[0], RecordedRun.of(cells[1], cells[2]), cells[5]);
    }

    /** How many steps are the same in each of CamSim's runs. */
    int comparable() {
      String[] words = hashOrder.split(" ");
      return hashOrder.equals("stable") ? run.steps() : Integer.parseInt(words[words.length - 1]);
    }

    @Override
    public String toString() {
      return file;
    }
  }

  static Stream<Recorded> outputs() throws IOException {
    List<String> lines = Files.readAllLines(Reference.file(FOLDER + "index.csv"));
    return lines.stream().skip(1).map(Recorded::of);
  }

  @Test
  void allOutputsAreCompared() throws IOException {
    assertEquals(29, outputs().count());
    assertEquals(28, outputs().filter(output -> output.hashOrder().equals("stable")).count());
  }

  @ParameterizedTest
  @MethodSource("outputs")
  void everyColumnEqualsTheRecordedOne(Recorded output) throws IOException {
    List<String> lines = Files.readAllLines(Reference.file(FOLDER + output.file()));
    assertEquals(
        "time;utility;communication;visible;strategy;totUtil;totComm;overlap;confidence;proportion",
        lines.get(0));
    List<StepFigures> ours = new ArrayList<>();
    output.run().run((world, network) -> ours.add(network.figures()));
    assertEquals(lines.size() - 1, ours.size());
    for (int step = 0; step < output.comparable(); step++) {
      assertRow(lines.get(step + 1), ours.get(step));
    }
    assertTrue(output.comparable() >= 200, output.comparable() + " steps compared");
  }

  @ParameterizedTest
  @MethodSource("outputs")
  void handoversEqualTheRecordedOnes(Recorded output) throws IOException {
    if (output.comparable() < output.run().steps()) {
      return;
    }
    String summary = output.file().replace(".csv", ".summary.csv");
    String[] recorded = Reference.rows(FOLDER + summary).get(0);
    long[] handovers = new long[1];
    output.run().run((world, network) -> handovers[0] += network.figures().handovers());
    assertEquals(Double.parseDouble(recorded[7]), (double) handovers[0]);
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
