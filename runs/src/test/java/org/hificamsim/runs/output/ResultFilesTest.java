package org.hificamsim.runs.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.Estimate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests writing and reading files of results. */
class ResultFilesTest {
  private record Item(long id, double size, String name, Estimate mean) {}

  private final Table<Item> items =
      Table.<Item>of("items.csv")
          .ints("id", "", "a number", item -> (int) item.id())
          .longs("big", "", "a large one", item -> item.id() << 40)
          .doubles("size", "m", "a length", Item::size)
          .plain("plain", "m", "the same", Item::size)
          .texts("name", "a text", Item::name)
          .estimates("mean", "", "m", "a mean", Item::mean);

  @TempDir Path folder;

  @Test
  void readsTableAsWritten() throws IOException {
    try (OutputFolder out = new OutputFolder(folder)) {
      items.write(
          out,
          Stream.of(
              new Item(1, 2.5, "a", new Estimate(1, 2, 3)),
              new Item(2, 3, "=b", new Estimate(4, 5, 6))));
      out.commit(List.of());
    }
    Path file = folder.resolve("items.csv");
    Estimate first = new Estimate(1, 2, 3);
    Estimate second = new Estimate(4, 5, 6);
    assertEquals(
        "id,big,size,plain,name,mean,low,high\n"
            + "1,1099511627776,2.5,2.5,a,%s,%s,%s\n"
                .formatted(first.mean(), first.low(), first.high())
            + "2,2199023255552,3.0,3,'=b,%s,%s,%s\n"
                .formatted(second.mean(), second.low(), second.high()),
        Files.readString(file));
    assertTrue(items.isIn(folder));
    assertFalse(Table.of("others.csv").isIn(folder));
    List<String> names = new ArrayList<>();
    items.read(folder, row -> names.add(row.text("name")));
    assertEquals(2, names.size());
    Files.writeString(file, Files.readString(file).replace("size", "length"));
    assertThrows(InputException.class, () -> items.read(folder));
    assertThrows(InputException.class, () -> items.read(folder, row -> {}));
  }

  @ParameterizedTest
  @CsvSource({
    "0.0, 0",
    "-3.0, -3",
    "2.5, 2.5",
    "9007199254740991, 9007199254740991",
    "9007199254740992, 9.007199254740992E15",
    "-9007199254740992, -9.007199254740992E15"
  })
  void writesWholeNumbersWithoutFraction(double value, String text) {
    assertEquals(text, JsonOutput.number(value).toString());
  }

  @Test
  void readsScoreFromLastCellOfRow() throws IOException {
    Path file = folder.resolve("steps.csv");
    List<StepRow> rows = new ArrayList<>();
    for (String malformed : List.of("1,2", "0,x,3,1.5", "0,1,3,z", "y,1,3,1", "0,1,")) {
      Files.writeString(file, "run,step,k_min,score\n10,7,3,2.5\n" + malformed + "\n");
      String message =
          assertThrows(InputException.class, () -> StepRow.forEachRow(folder, rows::add))
              .getMessage();
      assertEquals(
          file + ":3:1: '" + malformed + "' is no row, expected run,step,k_min,...,score, numbers",
          message);
      assertEquals(new StepRow(10, 7, 2.5), rows.get(rows.size() - 1));
    }
    Files.writeString(file, "run,step,k_min,score\n");
    assertEquals(file, StepRow.forEachRow(folder, rows::add));
  }

  @Test
  void rejectsMissingOrMalformedJson() throws IOException {
    ResultFolder results = new ResultFolder(folder);
    Path file = folder.resolve("summary.json");
    String missing =
        assertThrows(InputException.class, () -> results.json("summary.json")).getMessage();
    assertTrue(missing.startsWith("no file '" + file + "', expected a folder that"), missing);
    Files.writeString(file, "{\n \"a\": }");
    String broken =
        assertThrows(InputException.class, () -> results.json("summary.json")).getMessage();
    assertTrue(broken.startsWith(file + ":2:"), broken);
    assertTrue(broken.endsWith(": not JSON, expected what 'hificamsim' writes"), broken);
    for (String other : List.of("3", "\"a\"", "")) {
      Files.writeString(file, other);
      assertEquals(
          file + ": not a JSON object, expected what 'hificamsim' writes",
          assertThrows(InputException.class, () -> results.json("summary.json")).getMessage());
    }
    Files.writeString(file, "[1]");
    assertEquals(1, results.json("summary.json").get(0).asInt());
    assertEquals(folder.getFileName().toString(), ResultFolder.name(folder.resolve("a/..")));
  }

  @Test
  void quotesCommandForShell() throws IOException {
    Files.writeString(
        folder.resolve("manifest.json"),
        "{\"command\": [\"run\", \"a-b_1.xml\", \"it's\", \"\"], \"hificamsim\": \"0.2\"}");
    ResultFolder results = new ResultFolder(folder);
    assertEquals("./hificamsim run a-b_1.xml 'it'\\''s' ''", results.command());
    assertEquals("0.2", results.version());
  }

  /** The crate may be a file that another program wrote. */
  @Test
  void removesOnlyOwnFilesNamedByCrate() throws IOException {
    try (OutputFolder out = new OutputFolder(folder)) {
      for (String name :
          List.of("old.csv", "scenario-a.xml", "detection-a.json", "policy-a.onnx")) {
        out.write(name, "ours");
      }
      out.write(
          ResultFolder.CRATE,
          Stream.of("old.csv", "scenario-a.xml", "detection-a.json", "policy-a.onnx", "mine.csv")
              .map("{\"@type\": \"File\", \"name\": \"%s\"}"::formatted)
              .toList()
              .toString()
              .replaceFirst("(?s)(.*)", "{\"@graph\": $1}"));
      out.commit(List.of());
    }
    Files.writeString(folder.resolve("mine.csv"), "mine");
    commit();
    assertEquals(
        List.of(
            "detection-a.json",
            "mine.csv",
            "new",
            "policy-a.onnx",
            "ro-crate-metadata.json",
            "scenario-a.xml"),
        RunFolderTest.names(folder));
    Files.writeString(folder.resolve(ResultFolder.CRATE), "no JSON");
    commit(); // a damaged crate names no files
    assertTrue(RunFolderTest.names(folder).contains("policy-a.onnx"));
  }

  private void commit() throws IOException {
    try (OutputFolder out = new OutputFolder(folder)) {
      out.write("new", "ours");
      ResultFolder.commit(out, List.of());
    }
  }

  @Test
  void findsFilesNamedByOptionsOfPolicy() throws IOException {
    PolicyFiles policies = new PolicyFiles();
    Path file = Files.writeString(folder.resolve("net"), "weights");
    assertEquals(List.of(), policies.of("zoom-out"));
    assertEquals(List.of(), policies.of("unheard-of:file=" + file));
    assertEquals(
        "weights", new String(PolicyFiles.content(file), java.nio.charset.StandardCharsets.UTF_8));
    String message =
        assertThrows(InputException.class, () -> PolicyFiles.content(folder)).getMessage();
    assertEquals(folder + " cannot be read, expected a file of a policy", message);
  }
}
