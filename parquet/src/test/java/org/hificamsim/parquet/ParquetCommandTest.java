package org.hificamsim.parquet;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.cli.Main;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares {@code run --format parquet} with the same run in CSV. */
class ParquetCommandTest {
  private static final Path SCENARIOS = Path.of(System.getProperty("hificamsim.root"), "scenarios");

  @TempDir Path folder;
  private Path csv;
  private Path parquet;
  private final StringWriter errors = new StringWriter();

  @BeforeEach
  void nameFolders() {
    csv = folder.resolve("csv");
    parquet = folder.resolve("parquet");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "ring-random.xml --steps 3000 --repeat 2",
        "ring-random.xml --steps 300 --detect chance",
        "corridor.xml --steps 200 --detection dori-2014:level=recognise --policy sarsa",
      })
  void cellsEqualThoseOfCsv(String words) throws IOException {
    String[] scenarioAndOptions = words.split(" ", 2);
    runInBothFormats(SCENARIOS.resolve(scenarioAndOptions[0]), scenarioAndOptions[1].split(" "));
    assertSame("steps");
    assertSame("zooms");
    assertSame("targets");
  }

  @Test
  void pageNeedsCsv() throws IOException {
    runInBothFormats(SCENARIOS.resolve("ring-random.xml"), "--steps", "200");
    assertTrue(Files.exists(csv.resolve("report.html")));
    assertFalse(Files.exists(parquet.resolve("report.html")));
    assertEquals(2, run("report", parquet));
    String expected = "'%s' is not read here, expected a run with --format csv";
    assertEquals(
        "error: " + expected.formatted(parquet.resolve("steps.parquet")),
        errors.toString().lines().reduce((first, last) -> last).orElseThrow());
  }

  @Test
  void sameSeedWritesSameBytes() throws IOException {
    Path scenario = SCENARIOS.resolve("ring-random.xml");
    Path second = parquet.resolveSibling("second");
    assertEquals(0, run("run", scenario, "--steps", 500, "--format", "parquet", "--out", parquet));
    assertEquals(0, run("run", scenario, "--steps", 500, "--format", "parquet", "--out", second));
    assertArrayEquals(
        Files.readAllBytes(parquet.resolve("steps.parquet")),
        Files.readAllBytes(second.resolve("steps.parquet")));
  }

  @Test
  void replacesTablesOfOtherFormat() throws IOException {
    Path scenario = SCENARIOS.resolve("ring-random.xml");
    run("run", scenario, "--steps", 50, "--record", "--out", csv);
    run("run", scenario, "--steps", 50, "--format", "parquet", "--out", csv);
    assertEquals(List.of("steps.parquet"), tables(csv));
    assertTrue(
        Files.readString(csv.resolve("ro-crate-metadata.json"))
            .contains("application/vnd.apache.parquet"));
    run("run", scenario, "--steps", 50, "--out", csv);
    assertEquals(List.of("steps.csv"), tables(csv));
  }

  private void runInBothFormats(Path scenario, String... options) {
    List<Object> words = new ArrayList<>(List.of("run", scenario, "--record"));
    words.addAll(Arrays.asList(options));
    run(Stream.concat(words.stream(), Stream.of("--out", csv)).toArray());
    assertEquals("", errors.toString().replaceAll("(?m)^(warning|no page).*\n", ""));
    run(
        Stream.concat(words.stream(), Stream.of("--out", parquet, "--format", "parquet"))
            .toArray());
    assertEquals("", errors.toString().replaceAll("(?m)^(warning|no page).*\n", ""));
  }

  private int run(Object... words) {
    PrintWriter nowhere = new PrintWriter(new StringWriter());
    String[] args = Arrays.stream(words).map(Object::toString).toArray(String[]::new);
    return Main.execute(nowhere, new PrintWriter(errors, true), args);
  }

  private void assertSame(String table) throws IOException {
    List<String> expected = Files.readAllLines(csv.resolve(table + ".csv"));
    assertTrue(expected.size() > 1, table);
    assertEquals(expected.subList(1, expected.size()), rows(table));
  }

  private List<String> rows(String table) throws IOException {
    List<String> rows = new ArrayList<>();
    StoredFile.forEachRow(parquet.resolve(table + ".parquet"), rows::add);
    return rows;
  }

  private static List<String> tables(Path folder) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.matches("(steps|zooms|targets)\\..*"))
          .sorted()
          .toList();
    }
  }
}
