package org.hificamsim.core.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class UnfinishedTest {
  @TempDir Path folder;

  @AfterEach
  void resetEnding() {
    Unfinished.ending = false;
  }

  @Test
  void closeAllRemovesUncommittedFilesAndStopsWriting() throws IOException {
    OutputFile whole = new OutputFile(folder.resolve("whole"));
    whole.stream().close();
    whole.commit();
    OutputFile half = new OutputFile(folder.resolve("half"));
    half.stream().close();
    OutputFolder results = new OutputFolder(folder);
    results.write("steps.csv", "half");
    Unfinished.closeAll();
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(List.of(folder.resolve("whole")), files.toList());
    }
    assertEquals(
        "the program is ending", assertThrows(IOException.class, half::stream).getMessage());
  }

  @Test
  void forgetsFinishedFilesAndFolders() throws IOException {
    new OutputFile(folder.resolve("whole")).write("all of it");
    OutputFile committed = new OutputFile(folder.resolve("committed"));
    committed.stream().close();
    committed.commit();
    new OutputFile(folder.resolve("never")).close();
    new OutputFolder(folder).close();
    new OutputFolder(folder).release();
    OutputFile closed = new OutputFile(folder.resolve("closed"));
    closed.stream().close();
    closed.close();
    assertEquals(Set.of(), Unfinished.ALL);
  }
}
