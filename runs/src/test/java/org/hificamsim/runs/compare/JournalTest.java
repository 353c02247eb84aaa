package org.hificamsim.runs.compare;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunResult;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class JournalTest {
  private static final RunResult RESULT =
      RunResult.of(2, 7, Map.of(Metric.PERFORMANCE, 11.0, Metric.MEAN_K_MIN, 1.1));

  @TempDir Path folder;
  private OutputFolder output;

  @BeforeEach
  void writeJournalWithOneRun() throws IOException {
    output = new OutputFolder(folder);
    try (Journal journal = open(false)) {
      journal.add(
          "case", 7, new FinishedRun(RESULT, new int[] {3, 0, 8}, new double[] {0.25, 0, 1}));
    }
  }

  @AfterEach
  void unlockFolder() throws IOException {
    output.close();
  }

  @Test
  void findsFinishedRunsUnchangedAfterResume() throws IOException {
    try (Journal journal = open(true)) {
      FinishedRun found = journal.find("case", 7).orElseThrow();
      assertEquals(RESULT, found.result());
      assertArrayEquals(new int[] {3, 0, 8}, found.kMin());
      assertArrayEquals(new double[] {0.25, 0, 1}, found.scores());
      assertTrue(journal.find("case", 8).isEmpty());
      assertTrue(journal.find("other", 7).isEmpty());
    }
  }

  @Test
  void dropsRunsWithoutResume() throws IOException {
    open(false).close();
    try (Journal journal = open(true)) {
      assertTrue(journal.find("case", 7).isEmpty());
    }
  }

  @Test
  void dropsIncompleteLastLine() throws IOException {
    Files.writeString(file(), "{\"key\":\"half", StandardOpenOption.APPEND);
    addNextRun();
    assertFindsBothRuns();
    assertEquals(2, Files.readAllLines(file()).size());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "null",
        "{}",
        "[]",
        "nothing of use",
        "\0\0\0",
        "{\"key\":\"case/8\",\"result\":null,\"kMin\":\"eJxjYGBgAAAABAAB\"}",
        "{\"key\":null}"
      })
  void skipsDamagedLine(String line) throws IOException {
    Files.writeString(file(), line + "\n", StandardOpenOption.APPEND);
    addNextRun();
    assertFindsBothRuns();
    try (Journal journal = open(true)) {
      assertEquals(
          file() + ":2: the line is damaged",
          journal.damage().orElseThrow().lines().toList().get(0));
    }
  }

  @Test
  void checksumDetectsChangedJson() throws IOException {
    String text = Files.readString(file());
    assertTrue(text.contains("11.0"), text);
    Files.writeString(file(), text.replace("11.0", "99.0") + text.replace("case/7", "case/8"));
    try (Journal journal = open(true)) {
      assertTrue(journal.find("case", 7).isEmpty());
      assertTrue(journal.find("case", 8).isEmpty());
      assertEquals(
          file() + ":1: the line is damaged, and 1 more are", journal.damage().orElseThrow());
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"(\"kMin\":\"....).", "(\"kMin\":\".*).{4}(?=\")", "(\"kMin\":\").*(?=\")"})
  void skipsRunWithDamagedSteps(String damage) throws IOException {
    addNextRun();
    String text = Files.readString(file());
    Files.writeString(file(), text.replaceFirst(damage, "$1"));
    try (Journal journal = open(true)) {
      assertTrue(journal.find("case", 7).isEmpty());
      assertTrue(journal.find("next", 1).isPresent());
    }
  }

  @Test
  void handlesJournalsBeyondTwoGigabytes() throws IOException {
    long twoGigabytes = 1L << 31;
    byte[] line = ("\n" + Files.readString(file())).getBytes(StandardCharsets.UTF_8);
    addNextRun();
    String both = "\n" + Files.readString(file());
    try (FileChannel channel = FileChannel.open(file(), StandardOpenOption.WRITE)) {
      channel.truncate(0);
      channel.write(
          ByteBuffer.wrap(line), twoGigabytes); // after a hole, which takes no room on disk
    }
    try (Journal journal = open(true)) {
      assertTrue(journal.find("case", 7).isPresent());
      journal.add("next", 1, new FinishedRun(RESULT, new int[] {5}, new double[0]));
    }
    ByteBuffer written = ByteBuffer.allocate(both.length());
    try (FileChannel channel = FileChannel.open(file())) {
      channel.read(written, twoGigabytes);
      assertEquals(twoGigabytes + both.length(), channel.size());
    }
    assertEquals(both, new String(written.array(), StandardCharsets.UTF_8));
  }

  @Test
  void finishDeletesFile() throws IOException {
    open(true).finish();
    assertFalse(Files.exists(file()));
  }

  @Test
  void rejectsLink() throws IOException {
    Path target = Files.move(file(), folder.resolve("target"));
    byte[] before = Files.readAllBytes(target);
    Files.createSymbolicLink(file(), target);
    InputException e = assertThrows(InputException.class, () -> open(false));
    assertTrue(e.getMessage().contains("is a link"), e.getMessage());
    assertArrayEquals(before, Files.readAllBytes(target));
  }

  private void addNextRun() throws IOException {
    try (Journal journal = open(true)) {
      journal.add("next", 1, new FinishedRun(RESULT, new int[] {5}, new double[0]));
    }
  }

  private void assertFindsBothRuns() throws IOException {
    try (Journal journal = open(true)) {
      assertTrue(journal.find("case", 7).isPresent());
      assertTrue(journal.find("next", 1).isPresent());
    }
  }

  private Journal open(boolean resume) throws IOException {
    return Journal.open(output, Journal.COMPARISON_FILE, resume);
  }

  private Path file() {
    return folder.resolve(Journal.COMPARISON_FILE);
  }
}
