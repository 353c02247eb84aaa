package org.hificamsim.runs.benchmark;

import java.io.DataInputStream;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.NamedSetting;
import org.hificamsim.core.program.LimitedProgram;
import org.hificamsim.core.program.PythonInterpreter;
import org.hificamsim.core.program.Sandbox;

/**
 * Plays episodes of entered policies in a process of its own with limits ({@link EpisodeServer}).
 * Only the chosen views are taken from that process; the score is computed here, so that a policy
 * cannot fake it.
 */
final class EpisodeProgram implements AutoCloseable {
  private static final int HEAP_SHARE = 4;
  private static final Path JAVA = Path.of(System.getProperty("java.home"));

  private final Benchmark benchmark;
  private final EpisodeLimits limits;
  private final LimitedProgram program;

  /**
   * Starts the process.
   *
   * @param episodes the most episodes that it will play
   * @param entry the folder of the entry
   */
  EpisodeProgram(Benchmark benchmark, EpisodeLimits limits, int episodes, Path entry) {
    this.benchmark = benchmark;
    this.limits = limits;
    long seconds = (long) episodes * limits.seconds();
    try {
      Path folder = Files.createTempDirectory("episodes");
      List<Path> readable =
          new ArrayList<>(List.of(JAVA, benchmark.file().toAbsolutePath().getParent(), entry));
      readable.addAll(classPath());
      Optional<PythonInterpreter> python = python();
      python.ifPresent(found -> readable.addAll(found.folders()));
      program =
          new LimitedProgram(
              folder,
              command(folder, python),
              new Sandbox(seconds, limits.megabytes()).reading(readable));
    } catch (IOException e) {
      throw new InputException("Java cannot be run (" + e.getMessage() + "), expected it", e);
    }
  }

  /** The interpreter of Python files; empty if there is none, which other policies do not need. */
  private static Optional<PythonInterpreter> python() {
    try {
      return Optional.of(PythonInterpreter.find());
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  private List<String> command(Path folder, Optional<PythonInterpreter> python) {
    List<String> command = new ArrayList<>(List.of(JAVA.resolve("bin/java").toString()));
    command.add("-Xmx" + limits.megabytes() / HEAP_SHARE + "m");
    command.addAll(List.of("-XX:+UseSerialGC", "-XX:-UsePerfData", "-XX:-CreateCoredumpOnCrash"));
    command.addAll(List.of("-XX:CompressedClassSpaceSize=64m", "-XX:ReservedCodeCacheSize=64m"));
    command.add("-XX:ErrorFile=/dev/null");
    command.add("-Djava.io.tmpdir=" + folder);
    // the process does not inherit the environment, in which the interpreter would be found
    python.ifPresent(
        found -> command.add("-D" + PythonInterpreter.CALLER + "=" + found.executable()));
    String jars =
        classPath().stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator));
    command.addAll(List.of("-cp", jars, EpisodeServer.class.getName()));
    command.add(benchmark.file().toAbsolutePath().toString());
    return command;
  }

  private static List<Path> classPath() {
    return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
        .map(entry -> Path.of(entry).toAbsolutePath())
        .toList();
  }

  /**
   * Plays an episode.
   *
   * @throws InputException when the policy fails, or takes more than it may
   */
  Episode play(Trial trial) {
    String where = "policy " + trial.policy() + ", task " + trial.task();
    try {
      program.limit(limits.seconds());
      trial.write(program.out());
      program.out().flush();
      int[][] views = views(benchmark.task(trial.task()).steps(), cameras(trial));
      return Episode.replay(benchmark, trial.plan(benchmark), views, where);
    } catch (IOException e) {
      throw new InputException(where + " ended: " + program.reason(exceeded()), e);
    }
  }

  private int cameras(Trial trial) {
    return (int) benchmark.site(trial.task()).everyCamera().count();
  }

  private int[][] views(int steps, int cameras) throws IOException {
    DataInputStream in = program.in();
    int[][] views = new int[steps][cameras];
    for (int[] chosen : views) {
      for (int camera = 0; camera < cameras; camera++) {
        chosen[camera] = in.readInt();
      }
    }
    return views;
  }

  private String exceeded() {
    String seconds = NamedSetting.setting("seconds", Integer.toString(limits.seconds()));
    String memory = NamedSetting.setting("memory", Integer.toString(limits.megabytes()));
    return "out of time or memory, expected less than " + seconds + " and " + memory;
  }

  @Override
  public void close() {
    program.close();
  }
}
