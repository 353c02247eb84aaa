package org.hificamsim.core;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * What others' simulators recorded, and published tables (docs/evidence.md): ours to copy in the
 * tests' resources, the rest in a folder beside the project, and tests that need it skip without.
 */
public final class Reference {
  private static final Path ROOT = Path.of(System.getProperty("hificamsim.root", "."));
  private static final Path OURS = ROOT.resolve("src/test/resources/reference");
  private static final Path BESIDE = ROOT.resolve("../shared/reference").normalize();

  private Reference() {}

  /** A file or folder; the calling test is skipped where it is one that lies beside the project. */
  public static Path file(String name) {
    Path ours = OURS.resolve(name);
    return Files.exists(ours) ? ours : beside(name);
  }

  private static Path beside(String name) {
    String folder = name.split("/")[0];
    assumeTrue(
        Files.isDirectory(BESIDE.resolve(folder)),
        "needs ../shared/reference/%s, which carries no licence (docs/evidence.md)"
            .formatted(folder));
    Path file = BESIDE.resolve(name);
    assertFalse(Files.notExists(file), () -> "no reference " + file);
    return file;
  }

  /** All scenario files below a folder, in the order of their names. */
  public static List<Path> scenarios(String folder) {
    try (Stream<Path> files = Files.walk(file(folder))) {
      return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The rows of a CSV, without its header. */
  public static List<String[]> rows(String name) {
    try (Stream<String> lines = Files.lines(file(name))) {
      return lines.skip(1).map(line -> line.split(",")).toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
