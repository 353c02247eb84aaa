package org.hificamsim.bridge.run;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.scenario.Headings;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.StepOrder;

/** The scenario that CamSim runs, as far as result files name it: field and targets are unknown. */
final class RunningScenario {
  private static final String ENDING = ".xml";
  private static final String UNKNOWN = "camsim";
  private static final Field FIELD = new Field(Double.NaN, Double.NaN, Double.NaN, Double.NaN);

  private RunningScenario() {}

  /** The scenario with these radii and cameras. */
  static Scenario of(List<Double> zooms, List<CameraSpec> cameras) {
    return new Scenario(
        name(ProcessHandle.current().info().arguments().orElse(new String[0])),
        FIELD,
        StepOrder.CAMSIM,
        Headings.DEGREES,
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        zooms,
        cameras,
        List.of(),
        List.of(),
        Optional.empty(),
        Map.of());
  }

  /** The name of the last scenario file on the command line, without its ending. */
  static String name(String... arguments) {
    return Arrays.stream(arguments)
        .filter(argument -> argument.toLowerCase(Locale.ROOT).endsWith(ENDING))
        .reduce((first, second) -> second)
        .map(file -> Path.of(file).getFileName().toString())
        .map(file -> file.substring(0, file.length() - ENDING.length()))
        .orElse(UNKNOWN);
  }
}
