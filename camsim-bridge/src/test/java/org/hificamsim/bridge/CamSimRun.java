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
 * A run of the doubles of CamSim: {@link #start} and {@link #alone} take a JVM of its own, as a
 * user starts it; {@link #of} and {@link #shared} do without, which takes a tenth of the time.
 *
 * @param folder where it ran, and where its files are
 */
record CamSimRun(int exit, String out, String err, Path folder) {
  static final Path ROOT = Path.of(System.getProperty("hificamsim.root", ".")).toAbsolutePath();
  static final Path LIBS = ROOT.resolve("camsim-bridge/build/libs");
  static final Path DOUBLES = LIBS.resolve("camsim-doubles.jar");
  static final Path AGENT = LIBS.resolve("hificamsim-bridge.jar");
  static final Path CROSSING = ROOT.resolve("camsim-bridge/src/test/resources/crossing.xml");

  /** No agent at all. */
  static final String WITHOUT_AGENT = null;

  /** An agent without options. */
  static final String WITHOUT_OPTIONS = "";

  private static final Map<String, CamSimRun> SHARED = new HashMap<>();

  /** A run of the tests' scenario for 200 steps, shared by all tests that only read it. */
  static synchronized CamSimRun shared(String options) {
    return SHARED.computeIfAbsent(options, key -> of(untilTheEnd(), options));
  }

  private static Path untilTheEnd() {
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

  /** The same in a JVM of its own. */
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

  /** Runs a main class. */
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

  /** The lines of a file that it wrote, without the header. */
  List<String> rows(String file) {
    return text(file).lines().skip(1).toList();
  }

  /** A file that it wrote. */
  String text(String file) {
    return read(folder.resolve(file));
  }

  /** All that CamSim itself says and writes. */
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
