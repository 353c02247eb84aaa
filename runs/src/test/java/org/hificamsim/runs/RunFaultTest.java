package org.hificamsim.runs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.scenario.ScenarioReader;
import org.junit.jupiter.api.Test;

/** Tests the messages for exceptions of users' classes. */
class RunFaultTest {
  private static final Path SCENARIO =
      Path.of(System.getProperty("hificamsim.root", "."), "scenarios", "ring-random.xml");

  @Test
  void messageNamesRunStepClassAndLine() {
    RunFault fault =
        assertThrows(
            RunFault.class,
            () -> run((network, coverage) -> Objects.requireNonNull(atStepThree(network.step()))));
    String message = fault.getMessage();
    assertTrue(
        message.startsWith(
            "scenario ring-random, detection geometric, policy zoom-out, seed 8, step 3:"
                + " NullPointerException: null at org.hificamsim.runs.RunFaultTest"),
        message);
    assertTrue(message.matches(".*\\(RunFaultTest\\.java:\\d+\\)"), message);
  }

  @Test
  void passesOnFaultsOfInputAndFiles() {
    InputException wrong = new InputException("wrong");
    assertEquals(wrong, assertThrows(InputException.class, () -> run(throwing(wrong))));
    UncheckedIOException full = new UncheckedIOException(new IOException("disk full"));
    assertEquals(full, assertThrows(UncheckedIOException.class, () -> run(throwing(full))));
  }

  private static String atStepThree(long step) {
    return step == 3 ? null : "fine";
  }

  private static StepListener throwing(RuntimeException fault) {
    return (network, coverage) -> {
      throw fault;
    };
  }

  private static void run(StepListener listener) {
    Catalogue catalogue = Catalogue.load();
    RunPlan plan =
        new RunPlan(
            ScenarioReader.read(SCENARIO, catalogue.movements()::knows, warning -> {}),
            Detection.of(catalogue.detection("geometric")),
            "zoom-out",
            10,
            7,
            2);
    new RunExecutor(catalogue).repeat(plan, 1, List.of(listener));
  }
}
