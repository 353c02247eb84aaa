package org.hificamsim.core.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests records of files: their hashes and paths. */
class FileRecordTest {
  private static final String ABC =
      "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"; // FIPS 180-2, B.1

  @TempDir Path folder;

  @Test
  void hashesEqualThoseOfTheStandard() throws IOException {
    byte[] abc = {'a', 'b', 'c'};
    assertEquals(ABC, Sha256.of(abc));
    assertEquals(ABC, Sha256.of(Files.write(folder.resolve("abc"), abc)));
    assertEquals((byte) 0xba, Sha256.bytes(abc)[0]);
  }

  @Test
  void changedListsExistingFilesWithOtherContent() throws IOException {
    for (String name : List.of("same", "other", "gone")) {
      Files.writeString(folder.resolve(name), "abc");
    }
    Files.writeString(
        folder.resolve(FileRecord.NAME),
        "%1$s  gone\n%1$s  other\n%1$s  same\n%1$s  ../above\nnone of ours\n".formatted(ABC));
    FileRecord record = FileRecord.of(folder);
    assertEquals(Set.of("gone", "other", "same"), record.names());
    assertEquals(List.of(), record.changed(folder));
    Files.writeString(folder.resolve("other"), "abd");
    Files.delete(folder.resolve("gone"));
    assertEquals(List.of("other"), record.changed(folder));
  }

  @Test
  void rejectsSameFileForTwoOptions() throws IOException {
    Path below = Files.createDirectory(folder.resolve("below"));
    Path link = Files.createSymbolicLink(folder.resolve("link"), below);
    SeparateFiles files = new SeparateFiles();
    files.with("--out", below.resolve("a")).with("--page", below.resolve("b"));
    for (Path same : List.of(link.resolve("a"), below.resolve("x/../a"), below.resolve("./a"))) {
      InputException e =
          assertThrows(InputException.class, () -> files.with("--log", same), same::toString);
      assertEquals("--out and --log are one file, '" + same + "', expected two", e.getMessage());
    }
    assertEquals(Path.of("/"), SeparateFiles.real(Path.of("/")));
    assertEquals(Path.of("/none/a"), SeparateFiles.real(Path.of("/none/b/../a")));
  }

  @Test
  void createsMissingFolderOfFile() throws IOException {
    Path file = folder.resolve("new/place");
    OutputFile.inFolder("--out", file, false).write("ours");
    assertEquals("ours", Files.readString(file));
    String message =
        assertThrows(InputException.class, () -> OutputFile.inFolder("--out", Path.of("/"), true))
            .getMessage();
    assertTrue(message.startsWith("--out '/' is a folder"), message);
  }
}
