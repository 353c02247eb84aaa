package org.hificamsim.spark;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.junit.jupiter.api.io.TempDir;

/**
 * Runs a comparison with a user's policy and model file on a real cluster of a master and two
 * workers, one of which is killed.
 */
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class SparkClusterTest {
  private static final Path ROOT = Path.of(System.getProperty("hificamsim.root"));
  private static final Path EXAMPLE = ROOT.resolve("examples/own-policy/src");
  private static final Path OPTIONS = ROOT.resolve("spark/java.options");
  private static final int RUNS_BEFORE_KILL = 5;
  private static final String SHORT_LIVED = String.join(" ", SparkCluster.SHORT_LIVED);

  private static final String MODEL =
      """
      {"schema": "hificamsim-model", "version": 1, "name": "mine",
       "f": {"type": "linear", "z": -18.82, "q": -2.0, "d": 0.2, "intercept": 2.47},
       "g": {"slope": 0.571, "intercept": 0.026}, "threshold": 0.05}
      """;

  @TempDir static Path folder;
  private static Path home;
  private static Path policy;
  private static Path model;
  private static SparkCluster cluster;

  @BeforeAll
  static void startClusterAndComputeHere() throws Exception {
    home = SparkHome.require();
    policy = compiledPolicy();
    model = Files.writeString(folder.resolve("mine.json"), MODEL);
    cluster = new SparkCluster(home, folder, 2);
    assertEquals(0, driver("local", List.of()).start().waitFor(), log("local"));
  }

  @AfterAll
  static void stopCluster() {
    if (cluster != null) {
      cluster.close();
    }
  }

  @Test
  @Order(1)
  void losesNothingWhenWorkerIsKilled() throws Exception {
    Process driver =
        driver("killed", List.of("--engine", "spark", "--master", cluster.url())).start();
    try {
      SparkCluster.await(() -> !driver.isAlive() || journalled("killed") >= RUNS_BEFORE_KILL);
      assertTrue(driver.isAlive(), log("killed"));
      assertTrue(cluster.kill(2) > 0, "the worker had no executor");
      assertFalse(Files.exists(folder.resolve("killed/results.csv")), "killed after the end");
      assertEquals(0, driver.waitFor(), log("killed"));
    } finally {
      driver.destroyForcibly();
    }
    assertTrue(log("killed").contains("Lost executor"), log("killed"));
    assertSameFiles("killed");
  }

  @Test
  @Order(2)
  void runsUnderSparkSubmitOnRemainingWorker() throws Exception {
    Path jar = folder.resolve("policy.jar");
    try (ClassPathJars packed = new ClassPathJars(List.of(policy), home)) {
      Files.copy(Path.of(packed.paths().get(0)), jar);
    }
    List<String> command = new ArrayList<>();
    command.addAll(List.of(home.resolve("bin/spark-submit").toString(), "--master", cluster.url()));
    command.addAll(List.of("--conf", "spark.executor.memory=512m", "--jars", jar.toString()));
    command.addAll(List.of("--conf", "spark.driver.host=127.0.0.1"));
    command.addAll(List.of("--conf", "spark.executor.extraJavaOptions=" + SHORT_LIVED));
    command.addAll(List.of("--driver-java-options", SHORT_LIVED));
    command.addAll(List.of("--class", "org.hificamsim.cli.Main", application()));
    command.addAll(comparison("submitted", List.of("--engine", "spark")));
    ProcessBuilder submit = process("submitted", command);
    submit.environment().put("SPARK_HOME", home.toString());
    submit.environment().put("SPARK_LOCAL_IP", "127.0.0.1");
    assertEquals(0, submit.start().waitFor(), log("submitted"));
    assertSameFiles("submitted");
  }

  /** A command line as the launcher starts it. */
  private static ProcessBuilder driver(String name, List<String> engine) {
    List<String> command = new ArrayList<>();
    command.add(java());
    command.addAll(SparkCluster.SHORT_LIVED);
    command.addAll(List.of("@" + OPTIONS, "-Dspark.executor.memory=512m"));
    command.add("-Dspark.executor.extraJavaOptions=" + SHORT_LIVED);
    command.addAll(
        List.of("-Dspark.driver.host=127.0.0.1", "-Dspark.driver.bindAddress=127.0.0.1"));
    command.add("-Dlog4j2.configurationFile=" + ROOT.resolve("spark/log4j2.properties"));
    command.addAll(
        List.of(
            "-cp",
            String.join(File.pathSeparator, home + "/jars/*", application(), policy.toString())));
    command.add("org.hificamsim.cli.Main");
    command.addAll(comparison(name, engine));
    return process(name, command);
  }

  private static ProcessBuilder process(String name, List<String> command) {
    return new ProcessBuilder(command)
        .redirectErrorStream(true)
        .redirectOutput(folder.resolve(name + ".log").toFile());
  }

  private static List<String> comparison(String name, List<String> engine) {
    List<String> words = new ArrayList<>();
    words.addAll(List.of("compare", ROOT.resolve("scenarios/cluster-random.xml").toString()));
    words.addAll(List.of("--detections", "camsim-range," + model));
    words.addAll(List.of("--policies", "sarsa:gamma=0.9,lookout:patience=3"));
    words.addAll(List.of("--steps", "10000", "--repeat", "12", "--seed", "3"));
    words.addAll(List.of("--out", folder.resolve(name).toString()));
    words.addAll(engine);
    return words;
  }

  private static String java() {
    return Path.of(System.getProperty("java.home"), "bin", "java").toString();
  }

  private static String application() {
    return ROOT.resolve("spark/build/libs/hificamsim-spark.jar").toString();
  }

  private static String log(String name) {
    return SparkCluster.read(folder.resolve(name + ".log"));
  }

  private static long journalled(String name) {
    return SparkCluster.read(folder.resolve(name).resolve(".compare.journal")).lines().count();
  }

  private static void assertSameFiles(String name) throws IOException {
    List<String> expected = names("local");
    assertEquals(expected, names(name));
    assertTrue(expected.contains("results.csv") && expected.contains("steps.csv.gz"));
    for (String file : expected) {
      if (!List.of(".hificamsim.sha256", "manifest.json", "report.html", "ro-crate-metadata.json")
          .contains(file)) {
        assertArrayEquals(
            Files.readAllBytes(folder.resolve("local").resolve(file)),
            Files.readAllBytes(folder.resolve(name).resolve(file)),
            file);
      }
    }
  }

  private static List<String> names(String out) throws IOException {
    try (Stream<Path> files = Files.list(folder.resolve(out))) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  private static Path compiledPolicy() throws IOException {
    Path classes = Files.createDirectories(folder.resolve("policy"));
    int exit =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                null,
                "-d",
                classes.toString(),
                "-cp",
                application(),
                EXAMPLE.resolve("org/example/LookoutZoomPolicy.java").toString());
    assertEquals(0, exit);
    Path services = Path.of("META-INF/services/org.hificamsim.core.policy.ZoomPolicy");
    Files.createDirectories(classes.resolve(services).getParent());
    Files.copy(EXAMPLE.resolve(services), classes.resolve(services));
    return classes;
  }
}
