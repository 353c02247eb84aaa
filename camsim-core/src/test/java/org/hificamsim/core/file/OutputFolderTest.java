package org.hificamsim.core.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
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
    Files.writeString(folder.resolve("a"), "earlier");
  }

  @Test
  void allFilesAppearAtTheCommitAndStaleOnesGo() throws IOException {
    Files.writeString(folder.resolve("stale"), "earlier");
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
  void saysWhichFilesItHasWrittenAndWhere() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      write(output, "b.gz");
      assertEquals(List.of(), output.written());
      output.commit(List.of());
      write(output, "c");
      output.commit(List.of());
      write(output, "never");
      assertEquals(List.of("b.gz", "c"), output.written());
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
  }

  @Test
  void closedWithoutACommitItIsAsItWas() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      write(output, "a");
    }
    assertEquals(List.of("a"), names());
    assertEquals("earlier", Files.readString(folder.resolve("a")));
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

  private static void write(OutputFolder output, String name) throws IOException {
    try (Writer out = output.open(name)) {
      out.write("later");
    }
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }
}
