package epics.camwin;

import epics.camsim.core.SimCore;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;

/**
 * Runs scenarios in batch mode: {@code [-t STEPS] [-s SEED] [-o FILE] [-a CLASS] [-c N] [--no-gui]
 * SCENARIO.xml...}. Several scenarios run one after the other; the table of each but the first goes
 * to the subfolder {@code 1}, {@code 2}, ... of the output's folder. {@code -x} leaves files
 * unclosed, as CamSim does when its window is shut.
 */
public final class Main {
  private int steps = 100;
  private long seed;
  private Path output = Paths.get("output.csv");
  private boolean closing = true;
  private final List<File> scenarios = new ArrayList<>();

  private Main() {}

  /** Runs the scenarios. */
  public static void main(String[] args) throws IOException {
    Main main = new Main();
    main.read(args);
    for (int i = 0; i < main.scenarios.size(); i++) {
      main.run(i);
    }
  }

  private void read(String[] args) {
    for (int i = 0; i < args.length; i++) {
      switch (args[i]) {
        case "-t":
          steps = Integer.parseInt(args[++i]);
          break;
        case "-s":
          seed = Long.parseLong(args[++i]);
          break;
        case "-o":
          output = Paths.get(args[++i]);
          break;
        case "-a":
        case "-c":
          i++; // the doubles only have active schedules that broadcast
          break;
        case "-x":
          closing = false;
          break;
        case "--no-gui":
          break;
        default:
          scenarios.add(new File(args[i]));
      }
    }
  }

  private void run(int number) throws IOException {
    Path table = number == 0 ? output : outputInSubfolder(number);
    SimCore core = new SimCore(scenarios.get(number), seed, table);
    for (int step = 0; step < steps; step++) {
      core.update();
    }
    if (closing) {
      core.close_files();
    }
  }

  private Path outputInSubfolder(int number) throws IOException {
    Path folder = output.toAbsolutePath().resolveSibling(String.valueOf(number));
    return java.nio.file.Files.createDirectories(folder).resolve(output.getFileName());
  }
}
