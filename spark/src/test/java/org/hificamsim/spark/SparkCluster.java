package org.hificamsim.spark;

import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A standalone cluster on loopback: a master, and workers with one core, each a process. */
final class SparkCluster implements Closeable {
  private static final Duration PATIENCE = Duration.ofMinutes(4);

  /** Options for short-lived JVMs. */
  static final List<String> SHORT_LIVED = List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");

  private static final Pattern PORT =
      Pattern.compile("Successfully started service 'sparkMaster' on port (\\d+)");

  private final Path home;
  private final Path folder;
  private final List<Process> processes = new ArrayList<>();
  private final String url;

  /**
   * @param home the folder of Spark
   * @param folder the folder for logs and the workers' files
   */
  SparkCluster(Path home, Path folder, int workers) throws IOException {
    this.home = home;
    this.folder = folder;
    try {
      Path log = start("master", "org.apache.spark.deploy.master.Master", "--port", "0");
      await(() -> PORT.matcher(read(log)).find());
      Matcher port = PORT.matcher(read(log));
      url = port.find() ? "spark://127.0.0.1:" + port.group(1) : "";
      for (int worker = 1; worker <= workers; worker++) {
        startWorker("worker-" + worker);
      }
      for (int worker = 1; worker <= workers; worker++) {
        Path workerLog = folder.resolve("worker-" + worker + ".log");
        await(() -> read(workerLog).contains("Successfully registered with master"));
      }
    } catch (IOException | RuntimeException e) {
      close();
      throw e;
    }
  }

  String url() {
    return url;
  }

  /** Kills a worker and its executors; returns the number of processes. */
  int kill(int worker) {
    Process process = processes.get(worker);
    List<ProcessHandle> executors = process.descendants().toList();
    process.destroyForcibly();
    executors.forEach(ProcessHandle::destroyForcibly);
    return executors.size();
  }

  /** Waits for a condition. */
  static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE.toNanos();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        throw new IllegalStateException("not within " + PATIENCE);
      }
      try {
        TimeUnit.MILLISECONDS.sleep(50);
      } catch (InterruptedException e) {
        throw new IllegalStateException(e);
      }
    }
  }

  static String read(Path file) {
    try {
      return Files.exists(file) ? Files.readString(file) : "";
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void startWorker(String name) throws IOException {
    start(
        name,
        "org.apache.spark.deploy.worker.Worker",
        "--cores",
        "1",
        "--memory",
        "512m",
        "--work-dir",
        folder.resolve(name).toString(),
        url);
  }

  private Path start(String name, String main, String... arguments) throws IOException {
    Path log = folder.resolve(name + ".log");
    List<String> command = new ArrayList<>();
    command.add(home.resolve("bin/spark-class").toString());
    command.addAll(List.of(main, "--host", "127.0.0.1", "--webui-port", "0"));
    command.addAll(List.of(arguments));
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("SPARK_HOME", home.toString());
    builder.environment().put("SPARK_LOCAL_IP", "127.0.0.1");
    builder.environment().put("SPARK_DAEMON_MEMORY", "256m");
    builder.environment().put("SPARK_DAEMON_JAVA_OPTS", String.join(" ", SHORT_LIVED));
    builder.environment().put("SPARK_LAUNCHER_OPTS", String.join(" ", SHORT_LIVED));
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    builder.redirectErrorStream(true).redirectOutput(log.toFile());
    processes.add(builder.start());
    return log;
  }

  @Override
  public void close() {
    for (Process process : processes) {
      List<ProcessHandle> children = process.descendants().toList();
      process.destroyForcibly();
      children.forEach(ProcessHandle::destroyForcibly);
    }
    for (Process process : processes) {
      try {
        process.waitFor();
      } catch (InterruptedException e) {
        throw new IllegalStateException(e);
      }
    }
  }
}
