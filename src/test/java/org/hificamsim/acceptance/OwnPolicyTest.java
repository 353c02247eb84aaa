package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.ServiceLoader;
import java.util.stream.Stream;
import org.hificamsim.agents.ZoomPolicyContract;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests that the policy of {@code examples/own-policy} compiles and runs as its author would do it.
 */
class OwnPolicyTest {
  @TempDir static Path folder;

  private static Example lookout;

  @BeforeAll
  static void pack() throws IOException {
    lookout = Example.pack("own-policy", folder);
  }

  @Test
  void runsFromItsJarOnTheCommandLine(@TempDir Path out) throws Exception {
    Cli run =
        lookout.run(
            "run",
            Cli.scenario("lattice-random"),
            "--policy",
            "lookout:patience=3",
            "--steps",
            50,
            "--out",
            out);
    assertEquals(0, run.exit(), run.out());
    assertTrue(Files.readString(out.resolve("summary.json")).contains("\"lookout:patience=3\""));
  }

  @Test
  void unknownOptionListsThePolicysOptions(@TempDir Path out) throws Exception {
    Cli run =
        lookout.run(
            "run",
            Cli.scenario("lattice-random"),
            "--policy",
            "lookout:patients=3",
            "--out",
            out.resolve("none"));
    assertEquals(2, run.exit(), run.out());
    assertTrue(
        run.out().contains("unknown option 'patients=3', expected one of patience"), run.out());
  }

  @Test
  void missingServiceClassIsOneErrorLine(@TempDir Path jar) throws Exception {
    Path services = Files.createDirectories(jar.resolve("META-INF/services"));
    Files.writeString(services.resolve(ZoomPolicy.class.getName()), "org.example.Missing");
    Process run =
        Java.main(
            System.getProperty("java.class.path") + File.pathSeparator + jar,
            "run",
            Cli.scenario("lattice-random"),
            "--out",
            jar.resolve("none"));
    String output = new String(run.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(1, run.waitFor(), output);
    assertEquals(1, output.lines().count(), output);
    assertTrue(output.startsWith("error: ") && output.contains("org.example.Missing"), output);
    assertFalse(Files.exists(jar.resolve("none")));
  }

  @Test
  void showsStackTraceOnlyUnderDebug(@TempDir Path jar) throws Exception {
    Path services = Files.createDirectories(jar.resolve("META-INF/services"));
    Files.writeString(services.resolve(ZoomPolicy.class.getName()), Broken.class.getName());
    List<String> brief = outputLines(jar, List.of());
    List<String> debug = outputLines(jar, List.of("-Dhificamsim.debug=true"));
    String frame = " at " + Broken.class.getName() + ".decide(OwnPolicyTest.java:";
    assertEquals(1, brief.size(), brief.toString());
    assertTrue(brief.get(0).contains("step 0: IllegalStateException: torn" + frame), brief + "");
    assertEquals(brief.get(0), debug.get(debug.size() - 1));
    assertTrue(debug.stream().anyMatch(line -> line.startsWith("\t" + frame.strip())), debug + "");
  }

  private static List<String> outputLines(Path jar, List<String> options) throws Exception {
    Process run =
        Java.main(
            Path.of("."),
            options,
            System.getProperty("java.class.path") + File.pathSeparator + jar,
            "run",
            Cli.scenario("lattice-random"),
            "--policy",
            "broken",
            "--out",
            jar.resolve("none"));
    String output = new String(run.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(1, run.waitFor(), output);
    return output.lines().toList();
  }

  /** A policy that throws an exception. */
  public static final class Broken implements ZoomPolicy {
    @Override
    public String name() {
      return "broken";
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      throw new IllegalStateException("torn");
    }
  }

  @TestFactory
  Stream<DynamicTest> satisfiesContractOfPolicies() throws Exception {
    URLClassLoader loader = new URLClassLoader(new URL[] {lookout.jar().toUri().toURL()});
    return new ZoomPolicyContract(() -> lookout(loader), false)
        .tests()
        .onClose(() -> close(loader));
  }

  private static ZoomPolicy lookout(ClassLoader loader) {
    return ServiceLoader.load(ZoomPolicy.class, loader).stream()
        .filter(provider -> provider.type().getName().equals("org.example.LookoutZoomPolicy"))
        .map(
            provider ->
                new Registry<ZoomPolicy>("policy")
                    .register(
                        "lookout",
                        "own",
                        options -> {
                          ZoomPolicy policy = provider.get();
                          policy.configure(options);
                          return policy;
                        })
                    .create("lookout"))
        .findFirst()
        .orElseThrow();
  }

  private static void close(URLClassLoader loader) {
    try {
      loader.close();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
