package org.hificamsim.core.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OutputFileTest {
  @TempDir Path folder;

  @Test
  void replacesEarlierFileOnlyAtCommit() throws IOException {
    Path destination = Files.writeString(folder.resolve("place"), "earlier");
    try (OutputFile file = new OutputFile(destination)) {
      try (Writer out = file.open()) {
        out.write("later");
      }
      assertEquals("earlier", Files.readString(destination));
      file.commit();
    }
    assertEquals("later", Files.readString(destination));
    assertEquals(List.of("place"), names());
  }

  @Test
  void closeWithoutCommitDeletesTheDraft() throws IOException {
    try (OutputFile file = new OutputFile(folder.resolve("place"))) {
      file.open().close();
    }
    assertEquals(List.of(), names());
  }

  @Test
  void replacesLinkAndKeepsItsTarget() throws IOException {
    Path target = Files.writeString(folder.resolve("target"), "mine");
    Path link = Files.createSymbolicLink(folder.resolve("link"), target);
    new OutputFile(link).write("ours");
    assertEquals("mine", Files.readString(target));
    assertTrue(Files.isRegularFile(link, LinkOption.NOFOLLOW_LINKS));
  }

  @Test
  void neverWritesToExistingDraftOrLink() throws IOException {
    Path target = Files.writeString(folder.resolve("target"), "mine");
    Path link = Files.createSymbolicLink(folder.resolve("link"), target);
    for (Path planted : List.of(target, link)) {
      assertThrows(IOException.class, () -> OutputFile.stream(planted));
    }
    assertEquals("mine", Files.readString(target));
  }

  @Test
  void concurrentWritersLeaveOneWholeFile() throws IOException {
    Path destination = folder.resolve("place");
    List<String> texts = IntStream.range(0, 4).mapToObj(i -> (i + "\n").repeat(200_000)).toList();
    CompletableFuture.allOf(
            texts.stream()
                .map(text -> CompletableFuture.runAsync(() -> write(destination, text)))
                .toArray(CompletableFuture[]::new))
        .join();
    assertTrue(texts.contains(Files.readString(destination)));
    assertEquals(List.of("place"), names());
  }

  @Test
  void errorOfImpossibleFileNamesTheOption() {
    for (Path path : Set.of(folder, folder.resolve("missing/file"))) {
      InputException e =
          assertThrows(InputException.class, () -> OutputFile.of("--out", path, true));
      assertTrue(e.getMessage().startsWith("--out '" + path + "' "), e.getMessage());
    }
    assertFalse(Files.exists(folder.resolve("missing")));
  }

  @Test
  void writesFileInExistingFolder() throws IOException {
    OutputFile.of("--out", folder.resolve("place"), false).write("ours");
    OutputFile.of("--out", folder.resolve("place"), true).write("later");
    assertEquals("later", Files.readString(folder.resolve("place")));
  }

  private static void write(Path destination, String text) {
    try {
      new OutputFile(destination).write(text);
    } catch (IOException e) {
      throw new IllegalStateException(e);
    }
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  @Test
  void replacesExistingFileOnlyIfForced() throws IOException {
    Path destination = Files.writeString(folder.resolve("place"), "mine");
    Path link = Files.createSymbolicLink(folder.resolve("link"), folder.resolve("nowhere"));
    for (Path there : List.of(destination, link)) {
      InputException e =
          assertThrows(InputException.class, () -> OutputFile.of("--out", there, false));
      assertEquals(
          "--out '" + there + "' exists, expected a new file, or force to replace it",
          e.getMessage());
    }
    OutputFile later = OutputFile.of("--out", folder.resolve("later"), false);
    Files.writeString(folder.resolve("later"), "mine");
    assertThrows(InputException.class, () -> later.write("ours"));
    assertEquals("mine", Files.readString(folder.resolve("later")));
    assertEquals("mine", Files.readString(destination));
  }
}
