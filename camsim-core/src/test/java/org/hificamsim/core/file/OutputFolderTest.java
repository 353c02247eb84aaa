package org.hificamsim.core.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OutputFolderTest {
  @TempDir Path above;
  private Path folder;

  @BeforeEach
  void createFolderWithEarlierFile() throws IOException {
    folder = Files.createDirectory(above.resolve("folder"));
    writeEarlier("a");
  }

  private void writeEarlier(String... names) throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      for (String name : names) {
        output.write(name, "earlier");
      }
      output.commit(List.of());
    }
  }

  @Test
  void commitShowsNewFilesAndRemovesStaleOnes() throws IOException {
    writeEarlier("stale");
    try (OutputFolder output = new OutputFolder(folder)) {
      write(output, "a");
      write(output, "b");
      assertEquals("earlier", Files.readString(folder.resolve("a")));
      output.commit(List.of("b", "stale", "missing"));
    }
    assertEquals(List.of("a", "b"), names());
    assertEquals("later", Files.readString(folder.resolve("a")));
  }

  @Test
  void commitsOnlyFilesWrittenSinceLastCommit() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      write(output, "b.gz");
      output.commit(List.of());
      write(output, "c");
      output.commit(List.of());
      write(output, "never");
      assertEquals(folder, output.path());
    }
    assertEquals(List.of("a", "b.gz", "c"), names());
    try (TextLines lines = TextLines.open(folder.resolve("b.gz"))) {
      assertTrue(lines.next());
      assertEquals("later", lines.text());
    }
  }

  @Test
  void errorOfImpossibleFolderHasTheReason() throws IOException {
    Path file = folder.resolve("a");
    assertNotCreated("the folder for results has an empty name, expected one", Path.of(""));
    assertNotCreated("folder '" + file + "' is a file, expected a folder", file);
    Path below = file.resolve("below");
    assertNotCreated("folder '" + below + "' cannot be made: ", below);
    assertEquals(above.resolve("b/c"), OutputFolder.create(above.resolve("b/c")));
    assertTrue(Files.isDirectory(above.resolve("b/c")));
  }

  private static void assertNotCreated(String expected, Path path) {
    String message =
        assertThrows(InputException.class, () -> OutputFolder.create(path)).getMessage();
    assertEquals(expected, message.substring(0, Math.min(expected.length(), message.length())));
    assertTrue(message.matches(".*(expected .*|: [A-Za-z ]+)"), message);
    assertFalse(message.contains("Exception"), "what the system says: " + message);
  }

  @Test
  void errorWithoutReasonNamesTheExceptionClass() throws IOException {
    Path link = Files.createSymbolicLink(above.resolve("link"), above.resolve("nowhere"));
    String message =
        assertThrows(InputException.class, () -> OutputFolder.create(link)).getMessage();
    assertEquals("folder '" + link + "' cannot be made: FileAlreadyExistsException", message);
  }

  @Test
  void isRecognisedFromFirstDraftOn() throws IOException {
    Path other = above.resolve("other");
    assertFalse(OutputFolder.isOutputFolder(other));
    try (OutputFolder output = new OutputFolder(other)) {
      assertTrue(OutputFolder.isOutputFolder(other));
      write(output, "b");
      assertEquals("later", Files.readString(output.drafts().resolve("b")));
      output.commit(List.of());
    }
    assertTrue(OutputFolder.isOutputFolder(other));
  }

  @Test
  void keepsTheLastOfTwoWrites() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      output.write("b", "first");
      output.write("b", "last");
      output.commit(List.of());
    }
    assertEquals("last", Files.readString(folder.resolve("b")));
  }

  @Test
  void keepsUserEditsOfCommittedFiles() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      write(output, "b");
      output.commit(List.of());
      Files.writeString(folder.resolve("b"), "mine");
      write(output, "c");
      output.commit(List.of());
    }
    assertEquals("a=earlier b=mine c=later ", contents());
  }

  @Test
  void closeWithoutCommitChangesNothing() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      write(output, "a");
    }
    assertEquals("a=earlier ", contents());
    assertFalse(Files.exists(folder.resolve(".hificamsim")));
  }

  @Test
  void errorExplainsFoldersOfEarlierVersions() throws IOException {
    for (Path existing : List.of(folder, Files.createDirectory(above.resolve("old")))) {
      Files.writeString(existing.resolve("steps.csv"), "mine");
      try (OutputFolder output = new OutputFolder(existing)) {
        String message =
            assertThrows(InputException.class, () -> output.claim(List.of("steps.csv")))
                .getMessage();
        assertEquals(existing != folder, message.contains("versions before 0.2"), message);
      }
    }
  }

  @Test
  void rejectsSecondUserOfFolder() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      write(output, "a");
      InputException e = assertThrows(InputException.class, () -> new OutputFolder(folder));
      assertTrue(e.getMessage().contains("'" + folder + "' is in use by another run"));
      output.commit(List.of());
    }
    assertEquals("later", Files.readString(folder.resolve("a")));
    new OutputFolder(folder).close();
  }

  @Test
  void removesOnlyDraftsOfKilledProcess() throws IOException {
    Files.writeString(folder.resolve(".holiday-video-2023.part"), "another's");
    Path drafts = Files.createDirectory(folder.resolve(".hificamsim"));
    Files.writeString(drafts.resolve("lock"), "");
    Files.writeString(drafts.resolve("half"), "a fil");
    Path target = Files.writeString(above.resolve("target"), "mine");
    Files.createSymbolicLink(drafts.resolve("b"), target);
    try (OutputFolder output = new OutputFolder(folder)) {
      write(output, "b");
      output.commit(List.of());
    }
    assertEquals(List.of(".holiday-video-2023.part", "a", "b"), names());
    assertEquals("mine", Files.readString(target));
  }

  @Test
  void doesNotFollowLinkToDrafts() throws IOException {
    Path target = Files.createDirectory(above.resolve("target"));
    Files.writeString(target.resolve("a"), "mine");
    Files.createSymbolicLink(folder.resolve(".hificamsim"), target);
    assertThrows(InputException.class, () -> new OutputFolder(folder));
    assertEquals("mine", Files.readString(target.resolve("a")));
  }

  @Test
  void doesNotFollowLinkToLock() throws IOException {
    Path drafts = Files.createDirectory(folder.resolve(".hificamsim"));
    Path target = above.resolve("target");
    Files.createSymbolicLink(drafts.resolve("lock"), target);
    assertThrows(Exception.class, () -> new OutputFolder(folder));
    assertTrue(Files.notExists(target));
  }

  @Test
  void neitherReplacesNorRemovesForeignFiles() throws IOException {
    writeEarlier("changed", "stale");
    Files.writeString(folder.resolve("changed"), "mine");
    Files.writeString(folder.resolve("stale"), "mine");
    Files.writeString(folder.resolve("own"), "mine");
    Files.createSymbolicLink(folder.resolve("link"), above.resolve("nowhere"));
    try (OutputFolder output = new OutputFolder(folder)) {
      for (String name : List.of("changed", "own", "link")) {
        String message = assertThrows(InputException.class, () -> write(output, name)).getMessage();
        assertTrue(message.startsWith("'" + folder.resolve(name) + "' would be replaced"), message);
      }
      write(output, "late");
      Files.writeString(folder.resolve("late"), "mine");
      assertThrows(InputException.class, () -> output.commit(List.of()));
      Files.delete(folder.resolve("late"));
      output.commit(List.of("stale", "own", "a"));
    }
    assertEquals(List.of("changed", "late", "link", "own", "stale"), names());
    assertEquals("mine", Files.readString(folder.resolve("stale")));
  }

  @Test
  void keepsInputsEvenIfACommandWroteThem() throws IOException {
    Path link = Files.createSymbolicLink(above.resolve("link"), folder.resolve("a"));
    try (OutputFolder output = new OutputFolder(folder)) {
      output.keep(List.of(link));
      assertThrows(InputException.class, () -> output.claim(List.of("a")));
      write(output, "b");
      output.commit(List.of("a"));
    }
    assertEquals(List.of("a", "b"), names());
  }

  @Test
  void rejectsNamesOutsideTheFolder() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      for (String name : List.of("../a", "/a", "b/../../a", "a\nb", "", "a/")) {
        assertThrows(InputException.class, () -> write(output, name), name);
      }
      write(output, "below/b");
      output.commit(List.of());
    }
    assertEquals("later", Files.readString(folder.resolve("below/b")));
  }

  /** Simulates a kill: nothing catches it, so that nothing is cleaned up. */
  private static final class Killed extends Error {
    private static final long serialVersionUID = 1;
  }

  @Test
  void killLeavesOldOrNewFiles() throws IOException {
    Set<String> seen = new HashSet<>();
    boolean killed = true;
    for (int steps = 0; killed; steps++) {
      writeEarlier("a", "b", "stale");
      killed = killedAfter(steps);
      OutputFolder.settle(folder);
      String content = contents();
      assertTrue(
          Set.of("a=earlier b=earlier stale=earlier ", "a=later b=later ").contains(content));
      seen.add(content);
    }
    assertEquals(2, seen.size());
  }

  private boolean killedAfter(int steps) throws IOException {
    int[] left = {steps};
    OutputFolder output = null;
    try {
      output =
          new OutputFolder(
              folder,
              () -> {
                if (left[0]-- == 0) {
                  throw new Killed();
                }
              });
      write(output, "a");
      write(output, "b");
      output.commit(List.of("stale"));
      output.close();
      return false;
    } catch (Killed e) {
      if (output != null) {
        output.release();
      }
      return true;
    }
  }

  @Test
  void commitChangesTheDiskOncePerStep() throws IOException {
    writeEarlier("a", "b", "stale");
    List<Set<String>> steps = new ArrayList<>();
    List<Map<String, String>> readDisk = new ArrayList<>(List.of(Map.of()));
    Runnable compare =
        () -> {
          Map<String, String> now = Io.get(this::readDisk);
          Set<String> changed = new TreeSet<>(now.keySet());
          changed.addAll(readDisk.get(0).keySet());
          changed.removeIf(file -> Objects.equals(now.get(file), readDisk.get(0).get(file)));
          steps.add(changed);
          readDisk.set(0, now);
        };
    try (OutputFolder output = new OutputFolder(folder, compare)) {
      write(output, "a");
      write(output, "b");
      write(output, "new");
      compare.run();
      steps.clear();
      output.commit(List.of("stale"));
      write(output, "never");
      compare.run();
    }
    String hidden = ".hificamsim/";
    assertEquals(
        List.of(
            Set.of(),
            Set.of(hidden + "commit.part"),
            Set.of(hidden + "commit.part", hidden + "commit"),
            Set.of(hidden + "a", "a"),
            Set.of(hidden + "b", "b"),
            Set.of(hidden + "new", "new"),
            Set.of("stale"),
            Set.of(hidden + "commit", ".hificamsim.sha256", hidden + "never"),
            Set.of()), // before the draft goes
        steps);
  }

  private Map<String, String> readDisk() throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      Map<String, String> readDisk = new TreeMap<>();
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        readDisk.put(folder.relativize(file).toString(), Files.readString(file));
      }
      readDisk.remove(".hificamsim/lock");
      return readDisk;
    }
  }

  @Test
  void nextCommandCompletesFailedCommit() throws IOException {
    int[] steps = {0};
    OutputFolder output =
        new OutputFolder(
            folder,
            () -> {
              if (steps[0]++ == 2) {
                throw new IllegalStateException("the disk is full");
              }
            });
    write(output, "a");
    assertThrows(IllegalStateException.class, () -> output.commit(List.of()));
    output.close();
    assertEquals("a=earlier ", contents());
    OutputFolder.settle(folder);
    assertEquals("a=later ", contents());
  }

  private String contents() throws IOException {
    StringBuilder text = new StringBuilder();
    for (String name : names()) {
      text.append(name + "=" + Files.readString(folder.resolve(name)) + " ");
    }
    return text.toString();
  }

  @Test
  void killedRecoveryIsCompletedByNextCommand() throws IOException {
    writeEarlier("a", "b", "stale");
    assertTrue(killedAfter(3));
    assertTrue(Files.exists(folder.resolve(".hificamsim/commit")));
    // Killed while it completes the earlier commit.
    assertTrue(killedAfter(0));
    writeEarlier("c");
    assertEquals("a=later b=later c=earlier ", contents());
  }

  @Test
  void rejectsForeignFilesAmongDraftsInOneLine() throws IOException {
    Path below = Files.createDirectories(folder.resolve(".hificamsim/steps.csv/below"));
    String message =
        assertThrows(InputException.class, () -> new OutputFolder(folder)).getMessage();
    assertTrue(message.matches("'.*' cannot be used \\(.*\\), expected .*"), message);
    assertTrue(Files.exists(below));
    // The error has left no lock.
    assertThrows(InputException.class, () -> new OutputFolder(folder));
  }

  private static void write(OutputFolder output, String name) throws IOException {
    try (Writer out = output.open(name)) {
      out.write("later");
    }
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> !name.startsWith(".hificamsim"))
          .sorted()
          .toList();
    }
  }
}
