package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.hificamsim.runs.output.ManifestFile;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Element;

/**
 * Tests that the code in {@code docs/embedding.md} is that of the examples, which build and run.
 */
class EmbeddingGuideTest {
  private static final Path EXAMPLES = Cli.ROOT.resolve("examples");
  private static final Path REPOSITORY = Cli.ROOT.resolve("build/repository");
  private static final String VERSION = ManifestFile.version();
  private static final String GRADLE_HOME = System.getProperty("hificamsim.gradle");
  private static final Pattern BLOCK = Pattern.compile("```java\\n(.*?)```", Pattern.DOTALL);

  @Test
  void everyCodeBlockIsInAnExample() throws IOException {
    List<String> blocks =
        BLOCK
            .matcher(Files.readString(Cli.ROOT.resolve("docs/embedding.md")))
            .results()
            .map(MatchResult::group)
            .map(block -> block.substring("```java\n".length(), block.length() - "```".length()))
            .toList();
    assertEquals(7, blocks.size());
    String sources = sources();
    for (String block : blocks) {
      assertTrue(sources.contains(withoutIndentation(block)), "in no example: " + block);
    }
  }

  @Test
  void exampleBuildsWithPublishedLibraries(@TempDir Path folder) throws Exception {
    assumeTrue(GRADLE_HOME != null, "not started by Gradle");
    copy(EXAMPLES.resolve("embedding"), folder);
    String scenario = "-Pscenario=" + Cli.scenario("lattice-random").toRealPath();
    String output = gradle(folder, scenario, "tenLines", "ownParts");
    assertTrue(output.contains("step 2: camera Cam_01 sees "), output);
    assertTrue(output.contains("performance " + performance(folder)), output);
  }

  @Test
  void publishedContractTestsOwnPolicy(@TempDir Path folder) throws Exception {
    assumeTrue(GRADLE_HOME != null, "not started by Gradle");
    copy(EXAMPLES.resolve("own-policy"), folder);
    String output = gradle(folder, "contract");
    assertTrue(output.contains("allocatesNothingPerStep"), output);
    assertTrue(output.contains("0 tests failed"), output);
  }

  /** Returns the output of a Gradle build with the published libraries. */
  private static String gradle(Path folder, String... words) throws Exception {
    List<String> command = new ArrayList<>();
    command.add(Path.of(GRADLE_HOME, "bin", "gradle").toString());
    command.addAll(List.of("--no-daemon", "--offline", "--quiet"));
    command.add("-Dmaven.repo.local=" + REPOSITORY.toRealPath());
    command.addAll(List.of(words));
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().put("GRADLE_OPTS", String.join(" ", Java.SHORT_LIVED));
    Process process = builder.redirectErrorStream(true).start();
    process.getOutputStream().close();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), output);
    return output;
  }

  /** Returns the performance of the same run on the command line. */
  private static String performance(Path folder) throws IOException {
    Cli run =
        Cli.run(
            "run",
            Cli.scenario("lattice-random"),
            "--policy",
            "sarsa:gamma=0.9",
            "--seed",
            42,
            "--out",
            folder.resolve("out"));
    assertEquals(0, run.exit(), run.err());
    String summary = Files.readString(folder.resolve("out/summary.json"));
    return summary.replaceAll("(?s).*?\"performance\"\\s*:\\s*(\\d+).*", "$1");
  }

  @TestFactory
  Stream<DynamicTest> everyPomHasLicenceDescriptionAndDependencies() {
    Map<String, List<String>> libraries =
        Map.of(
            "camsim-core", List.of(),
            "data", List.of("camsim-core", "jackson-databind", "jackson-dataformat-csv"),
            "hifi-detection", List.of("data"),
            "solver", List.of("camsim-core"),
            "coverage-agents", List.of("solver", "software-and-algorithms"),
            "catalogue", List.of("coverage-agents", "hifi-detection"));
    return libraries.entrySet().stream()
        .map(
            library ->
                DynamicTest.dynamicTest(
                    library.getKey(), () -> checkPom(library.getKey(), library.getValue())));
  }

  private static void checkPom(String library, List<String> dependencies) throws Exception {
    Path files = REPOSITORY.resolve("org/hificamsim").resolve(library).resolve(VERSION);
    Path pom = files.resolve(library + "-" + VERSION + ".pom");
    Element root =
        DocumentBuilderFactory.newDefaultInstance()
            .newDocumentBuilder()
            .parse(pom.toFile())
            .getDocumentElement();
    Element license = (Element) root.getElementsByTagName("license").item(0);
    assertEquals("Apache-2.0", text(license, "name"));
    assertFalse(text(root, "description").isBlank());
    List<String> found = new ArrayList<>();
    for (int i = 0; i < root.getElementsByTagName("dependency").getLength(); i++) {
      found.add(text((Element) root.getElementsByTagName("dependency").item(i), "artifactId"));
    }
    assertEquals(dependencies, found);
    for (String ending : List.of(".jar", "-sources.jar")) {
      assertTrue(Files.size(files.resolve(library + "-" + VERSION + ending)) > 0);
    }
  }

  private static String text(Element parent, String name) {
    return parent.getElementsByTagName(name).item(0).getTextContent();
  }

  private static String sources() throws IOException {
    try (Stream<Path> files = Files.walk(EXAMPLES)) {
      return files
          .filter(file -> file.toString().endsWith(".java"))
          .sorted()
          .map(EmbeddingGuideTest::read)
          .map(EmbeddingGuideTest::withoutIndentation)
          .collect(Collectors.joining());
    }
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String withoutIndentation(String code) {
    return code.lines().map(String::strip).collect(Collectors.joining("\n")) + "\n";
  }

  private static void copy(Path from, Path to) throws IOException {
    try (Stream<Path> files = Files.walk(from)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        Path copy = to.resolve(from.relativize(file).toString());
        Files.createDirectories(copy.getParent());
        Files.copy(file, copy);
      }
    }
  }
}
