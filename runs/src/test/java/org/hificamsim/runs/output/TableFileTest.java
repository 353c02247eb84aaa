package org.hificamsim.runs.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.zip.GZIPOutputStream;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TableFileTest {
  private static final List<String> COLUMNS = List.of("a", "b");

  @TempDir Path folder;

  @Test
  void blocksTogetherAreTheTable() throws IOException {
    Path file = table("t.csv", "a,b\n1,2\n3,4\n5,6\n7,8\n9,x\n");
    List<TableFile> blocks = new ArrayList<>();
    TableFile.read(file, COLUMNS, 2, blocks::add);
    assertEquals(List.of(2, 2, 1), blocks.stream().map(block -> block.rows().size()).toList());
    assertEquals(7, blocks.get(1).number(1, "a"));
    assertEquals(5, TableFile.read(file, COLUMNS).rows().size());
    InputException refused = assertThrows(InputException.class, () -> blocks.get(2).number(0, "b"));
    assertTrue(refused.getMessage().startsWith(file + ":6:2: b is 'x'"), refused.getMessage());
  }

  @Test
  void aTableWithoutRowsIsOneEmptyBlock() throws IOException {
    List<TableFile> blocks = new ArrayList<>();
    TableFile.read(table("t.csv", "a,b\n"), COLUMNS, 2, blocks::add);
    assertEquals(1, blocks.size());
    assertEquals(List.of(), blocks.get(0).rows());
  }

  @Test
  void aQuoteWithoutItsEndIsRefusedWithItsPlace() throws IOException {
    Path file = table("t.csv", "a,b\n1,2\n\"3,4\n");
    refused(file, file + ":");
  }

  @Test
  void aCompressedTableThatIsCutOffIsRefused() throws IOException {
    StringBuilder text = new StringBuilder("a,b\n");
    SplittableRandom random = new SplittableRandom(1);
    for (int row = 0; row < 10_000; row++) {
      text.append(random.nextInt()).append(',').append(random.nextInt()).append('\n');
    }
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (OutputStream out = new GZIPOutputStream(packed)) {
      out.write(text.toString().getBytes(StandardCharsets.UTF_8));
    }
    Path file = folder.resolve("t.csv.gz");
    Files.write(file, Arrays.copyOf(packed.toByteArray(), packed.size() / 2));
    refused(file, file.toString());
    Files.writeString(file, "a,b\n1,2\n");
    refused(file, file.toString());
  }

  private static void refused(Path file, String start) {
    InputException refused =
        assertThrows(InputException.class, () -> TableFile.read(file, COLUMNS));
    assertTrue(refused.getMessage().startsWith(start), refused.getMessage());
    assertTrue(
        refused.getMessage().endsWith(", expected a table that 'hificamsim' writes"),
        refused.getMessage());
  }

  private Path table(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text);
  }
}
