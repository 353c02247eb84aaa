package org.hificamsim.acceptance;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the shipped sites, each with the detection that its first comment names. */
class SitesTest {
  private static final String SITES = "/org/hificamsim/acceptance/sites.csv";
  private static final Catalogue CATALOGUE = Catalogue.load();

  @TempDir Path folder;

  @ParameterizedTest
  @CsvFileSource(resources = SITES)
  void readsWithoutWarnings(String name, String detection) {
    List<String> warnings = new ArrayList<>();
    read(name, warnings);
    assertEquals(List.of(), warnings);
    Cli validate = Cli.run("validate", Cli.scenario(name), "--detection", detection, "--strict");
    assertEquals("", validate.err());
    assertEquals(0, validate.exit());
  }

  @ParameterizedTest
  @CsvFileSource(resources = SITES)
  void namesItsSourceAndDetection(String name, String detection) throws IOException {
    String comment = Files.readString(Cli.scenario(name)).split("-->", 2)[0];
    Scenario scenario = read(name, new ArrayList<>());
    assertEquals(Optional.of(detection), scenario.find(Scenario.DETECTION));
    assertTrue(comment.contains("Objective " + scenario.objective().text()), comment);
    assertTrue(comment.replaceAll("\\s+", " ").contains("Detection " + detection), comment);
    assertTrue(comment.contains("Value of adapting:"), comment);
  }

  @ParameterizedTest
  @CsvFileSource(resources = SITES)
  void runsWithEveryPolicy(String name, String detection) throws IOException {
    Path out = folder.resolve("out");
    List<String> policies = policiesFor(name);
    Cli compare = compare(name, detection, String.join(",", policies), 20, 1, out);
    assertEquals(0, compare.exit(), compare.err());
    assertEquals(policies.size() + 1, Files.readAllLines(out.resolve("results.csv")).size());
  }

  /** The runs are short; docs/world.md has the results of long ones. */
  @ParameterizedTest
  @CsvSource({
    "corridor, oodpcvs-2025:level=perceive",
    "border, ttpf:task=recognise",
    "warehouse, oodpcvs-2025:level=discern",
    "hall, oodpcvs-2025:level=perceive"
  })
  void adaptingGainsAtLeastAThird(String name, String detection) throws IOException {
    Path out = folder.resolve("out");
    Cli compare = compare(name, detection, "optimal", 100, 1, out);
    assertEquals(0, compare.exit(), compare.err());
    List<Double> values = values(out, "value_of_adapting");
    assertEquals(1, values.size());
    values.forEach(value -> assertTrue(value >= 1.3, name + " " + values));
    assertEquals(List.of(0.0), values(out, "unproven_steps"), "proven to be the optimum");
  }

  @Test
  void sitesDifferInTheirFeatures() throws IOException {
    Set<String> objectives = new HashSet<>();
    Set<Integer> cameras = new HashSet<>();
    for (String line : sites()) {
      Scenario scenario = read(line.split(",")[0].strip(), new ArrayList<>());
      objectives.add(scenario.objective().text());
      cameras.add(scenario.cameras().size());
      assertTrue(scenario.cameras().stream().map(CameraSpec::optics).allMatch(o -> o.isPresent()));
    }
    assertTrue(objectives.containsAll(Set.of("kmin", "covered:k=1", "covered:k=2")));
    assertTrue(cameras.containsAll(Set.of(4, 40)), cameras + " cameras");
  }

  /**
   * Returns the policies that can run on a site without a file: some need the objective k_min, and
   * some need cameras that see nothing while they turn.
   */
  private static List<String> policiesFor(String site) throws IOException {
    boolean byLeast = read(site, new ArrayList<>()).objective().byLeast();
    boolean sees = Files.readString(Cli.scenario(site)).contains("moving=\"sees\"");
    return CATALOGUE.policies().names().stream()
        .filter(name -> !name.equals("python"))
        .filter(name -> byLeast || !name.equals("optimal-expected"))
        .filter(name -> !sees || !name.equals("reachable"))
        .toList();
  }

  private static List<String> sites() throws IOException {
    try (InputStream stream = SitesTest.class.getResourceAsStream(SITES)) {
      return new String(stream.readAllBytes(), UTF_8).lines().toList();
    }
  }

  private static Scenario read(String name, List<String> warnings) {
    return ScenarioReader.read(Cli.scenario(name), CATALOGUE.movements()::knows, warnings::add);
  }

  private static Cli compare(
      String name, String detection, String policies, int steps, int repeats, Path out) {
    return Cli.run(
        "compare",
        Cli.scenario(name),
        "--detections",
        detection,
        "--policies",
        policies,
        "--steps",
        steps,
        "--repeat",
        repeats,
        "--out",
        out);
  }

  private static List<Double> values(Path out, String metric) throws IOException {
    List<List<String>> rows =
        Files.readAllLines(out.resolve("metrics.csv")).stream()
            .map(line -> List.of(line.split(",", -1)))
            .toList();
    int metricColumn = rows.get(0).indexOf("metric");
    int value = rows.get(0).indexOf("value");
    return rows.stream()
        .filter(row -> row.get(metricColumn).equals(metric))
        .map(row -> Double.parseDouble(row.get(value)))
        .toList();
  }
}
