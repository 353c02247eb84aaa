package org.hificamsim.onnx;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.cli.Main;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.RunKey;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Runs trained policies from the command line. */
class OnnxCommandTest {
  private static final Path CORRIDOR =
      Path.of(System.getProperty("hificamsim.root"), "scenarios", "corridor.xml");

  @TempDir Path folder;
  private final StringWriter errors = new StringWriter();

  private int run(Object... words) {
    PrintWriter ignoredOutput = new PrintWriter(new StringWriter());
    String[] args = Arrays.stream(words).map(Object::toString).toArray(String[]::new);
    return Main.execute(ignoredOutput, new PrintWriter(errors, true), args);
  }

  private int compare(String policies, Path out, Object... more) {
    Stream<Object> words =
        Stream.of(
            "compare",
            CORRIDOR,
            "--detections",
            "dori-2014:level=recognise",
            "--steps",
            50,
            "--repeat",
            2,
            "--policies",
            policies,
            "--out",
            out);
    return run(Stream.concat(words, Arrays.stream(more)).toArray());
  }

  @Test
  void comparisonHasSameResultsOnAnyNumberOfThreads() throws IOException {
    String policies = "random,onnx:" + Shipped.file("linear.onnx");
    assertEquals(0, compare(policies, folder.resolve("a"), "--threads", 1), errors::toString);
    assertEquals(0, compare(policies, folder.resolve("b"), "--threads", 4), errors::toString);
    List<String> results = Files.readAllLines(folder.resolve("a/results.csv"));
    assertTrue(results.stream().anyMatch(line -> line.contains("linear.onnx")));
    assertEquals(results, Files.readAllLines(folder.resolve("b/results.csv")));
  }

  @Test
  void resultFolderContainsNetwork() throws IOException {
    Path out = folder.resolve("out");
    assertEquals(
        0,
        run(
            "run",
            CORRIDOR,
            "--detection",
            "dori-2014:level=recognise",
            "--steps",
            20,
            "--policy",
            "onnx:file=" + Shipped.file("linear.onnx"),
            "--record",
            "--out",
            out),
        errors::toString);
    assertArrayEquals(
        Files.readAllBytes(Shipped.file("linear.onnx")),
        Files.readAllBytes(out.resolve("policy-linear.onnx")));
    assertTrue(
        Files.readString(out.resolve("ro-crate-metadata.json")).contains("policy-linear.onnx"));
  }

  @Test
  void fileNameWithEqualsSignNeedsKey() throws IOException {
    Path file = Files.createDirectories(folder.resolve("lr=0.1:b")).resolve("p.onnx");
    Files.copy(Shipped.file("linear.onnx"), file);
    assertEquals(0, compare("onnx:file=" + file, folder.resolve("c")), errors::toString);
    assertRejected("onnx:" + file, "unknown option");
  }

  @Test
  void runKeyDependsOnContentOfFile() throws IOException {
    Path file = folder.resolve("p.onnx");
    Files.copy(Shipped.file("linear.onnx"), file);
    RunKey before = key("onnx:" + file);
    assertEquals(before, key("onnx:" + file));
    RunKey random = key("random");
    Files.write(file, Files.readAllBytes(Shipped.file("nan.onnx")));
    assertNotEquals(before, key("onnx:" + file));
    assertTrue(key("onnx:" + file).changed(before).orElseThrow().contains("p.onnx"));
    assertEquals(random, key("random"));
    assertFalse(
        random.text().contains("onnx"), "the keys of other policies must not depend on the file");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "narrow.onnx | output 'values' is FLOAT of any x 5, expected float32 of 4 x 65",
        "short.onnx | input 'observations' is FLOAT of any x 10, expected float32 of 4 x 44",
        "odd.onnx | its metadata actions is 'jump', expected one of view, steps",
        "two.onnx | it has 2 outputs, expected one",
        "forgetful.onnx | it has an input 'state' alone, expected input 'state' and output"
            + " 'next_state'",
        "nan.onnx | gives NaN, expected numbers",
        "make_linear.py | is no network that ONNX Runtime knows",
        "missing.onnx | missing.onnx cannot be read, expected a trained network",
      })
  void rejectsUnsuitableNetworksInOneLine(String name, String expected) {
    Path network = Shipped.file("linear.onnx").resolveSibling(name);
    assertRejected("onnx:" + network, expected);
  }

  @Test
  void rejectsTruncatedFile() throws IOException {
    byte[] content = Files.readAllBytes(Shipped.file("linear.onnx"));
    Path truncated =
        Files.write(folder.resolve("half.onnx"), Arrays.copyOf(content, content.length / 2));
    assertRejected("onnx:" + truncated, "is no network that ONNX Runtime knows");
  }

  @Test
  void reportsOnlyReasonOfOnnxRuntimeError() throws IOException {
    byte[] damaged = Files.readAllBytes(Shipped.file("linear.onnx"));
    int biasLength = 11_540;
    damaged[biasLength] ^= 0x40;
    Path file = Files.write(folder.resolve("damaged.onnx"), damaged);
    assertRejected(
        "onnx:" + file, "expected a trained one: CopyLittleEndian source and destination buffer");
  }

  @Test
  void rejectsMissingFile() {
    assertRejected("onnx", "no file, expected a trained network: onnx:FILE");
    assertRejected("onnx:" + folder, "cannot be read");
  }

  private void assertRejected(String policy, String expected) {
    errors.getBuffer().setLength(0);
    Path out = folder.resolve("refused");
    assertEquals(2, compare(policy, out), errors::toString);
    assertEquals(1, errors.toString().lines().count(), errors::toString);
    assertTrue(errors.toString().contains(expected), errors::toString);
  }

  private static RunKey key(String policy) {
    Catalogue catalogue = Catalogue.load();
    return RunKey.of(
        new RunPlan(
            ScenarioReader.read(CORRIDOR, catalogue.movements()::knows, warning -> {}),
            new Detection(catalogue.detection("dori-2014:level=recognise"), 0.5),
            policy,
            10,
            0,
            1));
  }
}
