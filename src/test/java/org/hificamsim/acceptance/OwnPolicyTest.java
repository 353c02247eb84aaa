package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ServiceLoader;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.hificamsim.agents.ZoomPolicyContract;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/** The policy of {@code examples/own-policy}, compiled and run as its author would. */
class OwnPolicyTest {
  private static final Path SOURCE = Cli.ROOT.resolve("examples/own-policy/src");

  @TempDir static Path classes;

  @BeforeAll
  static void compile() throws IOException {
    int exit =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                null,
                "-d",
                classes.toString(),
                "-cp",
                System.getProperty("java.class.path"),
                SOURCE.resolve("org/example/PatrolZoomPolicy.java").toString());
    assertEquals(0, exit);
    Path services = Files.createDirectories(classes.resolve("META-INF/services"));
    String service = ZoomPolicy.class.getName();
    Files.copy(SOURCE.resolve("META-INF/services").resolve(service), services.resolve(service));
  }

  @Test
  void runsFromTheCommandLineWithNothingButItsClassPath(@TempDir Path out) throws Exception {
    Process run =
        Java.main(
            System.getProperty("java.class.path") + File.pathSeparator + classes,
            "run",
            Cli.scenario("lattice-random"),
            "--policy",
            "patrol:patience=3",
            "--steps",
            50,
            "--out",
            out);
    String said = new String(run.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, run.waitFor(), said);
    assertTrue(Files.readString(out.resolve("summary.json")).contains("\"patrol:patience=3\""));
  }

  @Test
  void anUnknownOptionOfItIsAnErrorThatListsItsOwn(@TempDir Path out) throws Exception {
    Process run =
        Java.main(
            System.getProperty("java.class.path") + File.pathSeparator + classes,
            "run",
            Cli.scenario("lattice-random"),
            "--policy",
            "patrol:patients=3",
            "--out",
            out.resolve("none"));
    String said = new String(run.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(2, run.waitFor(), said);
    assertTrue(said.contains("unknown option 'patients=3', expected one of patience"), said);
  }

  @TestFactory
  Stream<DynamicTest> keepsTheContractOfPolicies() throws Exception {
    URLClassLoader loader = new URLClassLoader(new URL[] {classes.toUri().toURL()});
    return new ZoomPolicyContract(() -> patrol(loader), false).tests().onClose(() -> close(loader));
  }

  private static ZoomPolicy patrol(ClassLoader loader) {
    return ServiceLoader.load(ZoomPolicy.class, loader).stream()
        .filter(provider -> provider.type().getName().equals("org.example.PatrolZoomPolicy"))
        .map(
            provider ->
                new Registry<ZoomPolicy>("policy")
                    .register(
                        "patrol",
                        "own",
                        options -> {
                          ZoomPolicy policy = provider.get();
                          policy.configure(options);
                          return policy;
                        })
                    .create("patrol"))
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
