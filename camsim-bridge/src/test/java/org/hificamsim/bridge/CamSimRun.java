package org.hificamsim.bridge;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A run of the doubles of CamSim. {@link #start} and {@link #alone} start a JVM for it, as users
 * do; {@link #of} and {@link #shared} run it in this JVM, which takes a tenth of the time.
 *
 * @param exit the exit code
 * @param out the standard output
 * @param err the standard error
 * @param folder the folder in which it ran and wrote its files
 */
record CamSimRun(int exit, String out, String err, Path folder) {
  static final Path ROOT = Path.of(System.getProperty("hificamsim.root", ".")).toAbsolutePath();
  static final Path LIBS = ROOT.resolve("camsim-bridge/build/libs");
  static final Path DOUBLES = LIBS.resolve("camsim-doubles.jar");
  static final Path AGENT = LIBS.resolve("hificamsim-bridge.jar");
  static final Path CROSSING = ROOT.resolve("camsim-bridge/src/test/resources/crossing.xml");

  /** The options of a run without an agent. */
  static final String WITHOUT_AGENT = null;

  /** The options of a run with an agent that has no options. */
  static final String WITHOUT_OPTIONS = "";

  private static final Map<String, CamSimRun> SHARED = new HashMap<>();

  /** Runs the tests' scenario for 200 steps; tests that only read the files share the run. */
  static synchronized CamSimRun shared(String options) {
    return SHARED.computeIfAbsent(options, key -> of(folderUntilExit(), options));
  }

  private static Path folderUntilExit() {
    try {
      Path folder = Files.createTempDirectory("camsim");
      Runtime.getRuntime().addShutdownHook(new Thread(() -> delete(folder)));
      return folder;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void delete(Path folder) {
    try (Stream<Path> all = Files.walk(folder)) {
      all.sorted(Comparator.reverseOrder()).map(Path::toFile).forEach(File::delete);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Runs a scenario for some steps, with seed 0. */
  static CamSimRun of(Path folder, String options, Path scenario, int steps) {
    return WovenDoubles.run(folder, options, scenario, steps);
  }

  /** Runs a scenario for some steps, with seed 0, in a JVM of its own. */
  static CamSimRun alone(Path folder, String options, Path scenario, int steps) {
    return start(
        folder,
        options,
        List.of(DOUBLES),
        "epics.camwin.Main",
        List.of("--no-gui", "-t", "" + steps, "-o", "output.csv", scenario.toString()));
  }

  /** Runs the scenario of the tests for 200 steps. */
  static CamSimRun of(Path folder, String options) {
    return of(folder, options, CROSSING, 200);
  }

  /** Runs a main class in a JVM of its own. */
  static CamSimRun start(
      Path folder, String options, List<Path> classPath, String main, List<String> arguments) {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1"));
    command.add("-Xshare:auto");
    if (options != null) {
      command.add("-javaagent:" + AGENT + (options.isEmpty() ? "" : "=" + options));
    }
    command.add("-cp");
    command.add(
        classPath.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator)));
    command.add(main);
    command.addAll(arguments);
    return run(command, folder);
  }

  private static CamSimRun run(List<String> command, Path folder) {
    try {
      Files.createDirectories(folder);
      Path out = folder.resolve("stdout");
      Path err = folder.resolve("stderr");
      Process process =
          new ProcessBuilder(command)
              .directory(folder.toFile())
              .redirectOutput(out.toFile())
              .redirectError(err.toFile())
              .start();
      if (!process.waitFor(2, TimeUnit.MINUTES)) {
        process.destroyForcibly();
        throw new IllegalStateException("still running: " + command);
      }
      return new CamSimRun(process.exitValue(), read(out), read(err), folder);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Returns the lines of a file that the run wrote, without the header. */
  List<String> rows(String file) {
    return text(file).lines().skip(1).toList();
  }

  /** Returns the text of a file that the run wrote. */
  String text(String file) {
    return read(folder.resolve(file));
  }

  /** Returns all that CamSim itself prints and writes. */
  String all() {
    return exit + "\n" + out + text("output.csv") + text("looks.csv");
  }

  private static String read(Path file) {
    try {
      return Files.readString(file, StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
