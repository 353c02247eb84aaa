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
  void makeItWithAnEarlierFile() throws IOException {
    folder = Files.createDirectory(above.resolve("folder"));
    earlier("a");
  }

  private void earlier(String... names) throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      for (String name : names) {
        output.write(name, "earlier");
      }
      output.commit(List.of());
    }
  }

  @Test
  void allFilesAppearAtTheCommitAndStaleOnesGo() throws IOException {
    earlier("stale");
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
  void commitsWhatWasWrittenSinceTheLastOneAndNothingElse() throws IOException {
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
  void aFolderThatCannotBeMadeIsToldWithTheReason() throws IOException {
    Path file = folder.resolve("a");
    assertMade("the folder for results has an empty name, expected one", Path.of(""));
    assertMade("folder '" + file + "' is a file, expected a folder", file);
    Path below = file.resolve("below");
    assertMade("folder '" + below + "' cannot be made: ", below);
    assertEquals(above.resolve("b/c"), OutputFolder.made(above.resolve("b/c")));
    assertTrue(Files.isDirectory(above.resolve("b/c")));
  }

  private static void assertMade(String refused, Path path) {
    String told = assertThrows(InputException.class, () -> OutputFolder.made(path)).getMessage();
    assertEquals(refused, told.substring(0, Math.min(refused.length(), told.length())));
    assertTrue(told.matches(".*(expected .*|: [A-Za-z ]+)"), told);
    assertFalse(told.contains("Exception"), "what the system says: " + told);
  }

  @Test
  void whereTheSystemGivesNoReasonTheKindOfFaultIsOne() throws IOException {
    Path link = Files.createSymbolicLink(above.resolve("link"), above.resolve("nowhere"));
    String told = assertThrows(InputException.class, () -> OutputFolder.made(link)).getMessage();
    assertEquals("folder '" + link + "' cannot be made: FileAlreadyExistsException", told);
  }

  @Test
  void itIsOneFromTheFirstDraftOn() throws IOException {
    Path other = above.resolve("other");
    assertFalse(OutputFolder.isOne(other));
    try (OutputFolder output = new OutputFolder(other)) {
      assertTrue(OutputFolder.isOne(other));
      write(output, "b");
      assertEquals("later", Files.readString(output.drafts().resolve("b")));
      output.commit(List.of());
    }
    assertTrue(OutputFolder.isOne(other));
  }

  @Test
  void whatIsWrittenTwiceIsWhatWasWrittenLast() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      output.write("b", "first");
      output.write("b", "last");
      output.commit(List.of());
    }
    assertEquals("last", Files.readString(folder.resolve("b")));
  }

  @Test
  void whatIsCommittedMayBeTheUsersBeforeTheNextCommit() throws IOException {
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
  void closedWithoutACommitItIsAsItWas() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      write(output, "a");
    }
    assertEquals("a=earlier ", contents());
    assertFalse(Files.exists(folder.resolve(".hificamsim")));
  }

  @Test
  void aFolderWithoutARecordMayBeOfAnEarlierVersion() throws IOException {
    for (Path one : List.of(folder, Files.createDirectory(above.resolve("old")))) {
      Files.writeString(one.resolve("steps.csv"), "mine");
      try (OutputFolder output = new OutputFolder(one)) {
        String told =
            assertThrows(InputException.class, () -> output.claim(List.of("steps.csv")))
                .getMessage();
        assertEquals(one != folder, told.contains("versions before 0.2"), told);
      }
    }
  }

  @Test
  void whoHoldsItKeepsAllOthersOut() throws IOException {
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
  void whatAKilledProcessLeftIsRemovedAndNothingOfOthers() throws IOException {
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
  void aLinkInPlaceOfItsDraftsIsNotFollowed() throws IOException {
    Path target = Files.createDirectory(above.resolve("target"));
    Files.writeString(target.resolve("a"), "mine");
    Files.createSymbolicLink(folder.resolve(".hificamsim"), target);
    assertThrows(InputException.class, () -> new OutputFolder(folder));
    assertEquals("mine", Files.readString(target.resolve("a")));
  }

  @Test
  void aLinkInPlaceOfItsLockIsNotFollowed() throws IOException {
    Path drafts = Files.createDirectory(folder.resolve(".hificamsim"));
    Path target = above.resolve("target");
    Files.createSymbolicLink(drafts.resolve("lock"), target);
    assertThrows(Exception.class, () -> new OutputFolder(folder));
    assertTrue(Files.notExists(target));
  }

  @Test
  void whatNoCommandWroteIsNeitherReplacedNorRemoved() throws IOException {
    earlier("changed", "stale");
    Files.writeString(folder.resolve("changed"), "mine");
    Files.writeString(folder.resolve("stale"), "mine");
    Files.writeString(folder.resolve("own"), "mine");
    Files.createSymbolicLink(folder.resolve("link"), above.resolve("nowhere"));
    try (OutputFolder output = new OutputFolder(folder)) {
      for (String name : List.of("changed", "own", "link")) {
        String told = assertThrows(InputException.class, () -> write(output, name)).getMessage();
        assertTrue(told.startsWith("'" + folder.resolve(name) + "' would be replaced"), told);
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
  void whatTheCommandReadsIsKeptEvenIfACommandWroteIt() throws IOException {
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
  void namesStayBelowTheFolder() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      for (String name : List.of("../a", "/a", "b/../../a", "a\nb", "", "a/")) {
        assertThrows(InputException.class, () -> write(output, name), name);
      }
      write(output, "below/b");
      output.commit(List.of());
    }
    assertEquals("later", Files.readString(folder.resolve("below/b")));
  }

  /** What a killed process leaves is no exception: it does nothing more. */
  private static final class Killed extends Error {
    private static final long serialVersionUID = 1;
  }

  @Test
  void killedAtAnyStepTheFolderIsTheOldOneOrTheNewOne() throws IOException {
    Set<String> seen = new HashSet<>();
    boolean killed = true;
    for (int acts = 0; killed; acts++) {
      earlier("a", "b", "stale");
      killed = killedAfter(acts);
      OutputFolder.settle(folder);
      String content = contents();
      assertTrue(
          Set.of("a=earlier b=earlier stale=earlier ", "a=later b=later ").contains(content));
      seen.add(content);
    }
    assertEquals(2, seen.size());
  }

  private boolean killedAfter(int acts) throws IOException {
    int[] left = {acts};
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
  void betweenTwoStepsTheDiskChangesOnce() throws IOException {
    earlier("a", "b", "stale");
    List<Set<String>> steps = new ArrayList<>();
    List<Map<String, String>> disk = new ArrayList<>(List.of(Map.of()));
    Runnable compare =
        () -> {
          Map<String, String> now = Io.get(this::disk);
          Set<String> changed = new TreeSet<>(now.keySet());
          changed.addAll(disk.get(0).keySet());
          changed.removeIf(file -> Objects.equals(now.get(file), disk.get(0).get(file)));
          steps.add(changed);
          disk.set(0, now);
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

  private Map<String, String> disk() throws IOException {
    try (Stream<Path> files = Files.walk(folder)) {
      Map<String, String> disk = new TreeMap<>();
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        disk.put(folder.relativize(file).toString(), Files.readString(file));
      }
      disk.remove(".hificamsim/lock");
      return disk;
    }
  }

  @Test
  void aCommitThatFailsOnceItIsDecidedIsEndedByTheNext() throws IOException {
    int[] acts = {0};
    OutputFolder output =
        new OutputFolder(
            folder,
            () -> {
              if (acts[0]++ == 2) {
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
    StringBuilder all = new StringBuilder();
    for (String name : names()) {
      all.append(name + "=" + Files.readString(folder.resolve(name)) + " ");
    }
    return all.toString();
  }

  @Test
  void anUnfinishedCommitIsEndedByTheNextCommandAndTheOneAfterKilledThere() throws IOException {
    earlier("a", "b", "stale");
    assertTrue(killedAfter(3));
    assertTrue(Files.exists(folder.resolve(".hificamsim/commit")));
    assertTrue(killedAfter(0)); // while it ends what the other has left
    earlier("c");
    assertEquals("a=later b=later c=earlier ", contents());
  }

  @Test
  void whatIsNotOursInItsDraftsIsRefusedInOneLine() throws IOException {
    Path below = Files.createDirectories(folder.resolve(".hificamsim/steps.csv/below"));
    String told = assertThrows(InputException.class, () -> new OutputFolder(folder)).getMessage();
    assertTrue(told.matches("'.*' cannot be used \\(.*\\), expected .*"), told);
    assertTrue(Files.exists(below));
    assertThrows(InputException.class, () -> new OutputFolder(folder)); // and no lock is left
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
