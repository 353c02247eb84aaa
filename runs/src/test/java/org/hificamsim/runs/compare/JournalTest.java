package org.hificamsim.runs.compare;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.hificamsim.runs.RunResult;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class JournalTest {
  private static final RunResult RESULT =
      new RunResult(2, 7, 11, 1.1, 0.25, 0.5, 0.25, 1.25, 50, 6, 4);

  @TempDir Path folder;

  @BeforeEach
  void leaveTheJournalOfAKilledComparison() throws IOException {
    try (Journal journal = new Journal(folder, false)) {
      journal.add("case", 7, new Outcome(RESULT, new int[] {3, 0, 8}));
    }
  }

  @Test
  void resumingFindsWhatWasFinishedBitByBit() throws IOException {
    try (Journal journal = new Journal(folder, true)) {
      Outcome found = journal.find("case", 7).orElseThrow();
      assertEquals(RESULT, found.result());
      assertArrayEquals(new int[] {3, 0, 8}, found.kMin());
      assertTrue(journal.find("case", 8).isEmpty());
      assertTrue(journal.find("other", 7).isEmpty());
    }
  }

  @Test
  void notResumingForgetsIt() throws IOException {
    new Journal(folder, false).close();
    try (Journal journal = new Journal(folder, true)) {
      assertTrue(journal.find("case", 7).isEmpty());
    }
  }

  @Test
  void aLineCutOffIsDroppedAndTheNextOneFollowsTheWholeOnes() throws IOException {
    Files.writeString(file(), "{\"key\":\"half", StandardOpenOption.APPEND);
    try (Journal journal = new Journal(folder, true)) {
      journal.add("next", 1, new Outcome(RESULT, new int[] {5}));
    }
    try (Journal journal = new Journal(folder, true)) {
      assertTrue(journal.find("case", 7).isPresent());
      assertTrue(journal.find("next", 1).isPresent());
    }
    assertEquals(2, Files.readAllLines(file()).size());
  }

  @Test
  void finishingRemovesTheFile() throws IOException {
    new Journal(folder, true).finish();
    assertFalse(Files.exists(file()));
  }

  private Path file() {
    return folder.resolve(Journal.NAME);
  }
}
