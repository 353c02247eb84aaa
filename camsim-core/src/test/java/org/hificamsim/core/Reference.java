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
 * Records of other simulators, and published tables (docs/evidence.md). Those with a licence to
 * copy are resources of the tests; the rest is in a folder next to the project, and tests that need
 * it are skipped without it.
 */
public final class Reference {
  private static final Path ROOT = Path.of(System.getProperty("hificamsim.root", "."));
  private static final Path INCLUDED = ROOT.resolve("src/test/resources/reference");
  private static final Path EXTERNAL = ROOT.resolve("../shared/reference").normalize();

  private Reference() {}

  /**
   * Returns a file or folder; skips the calling test if its folder next to the project is missing.
   */
  public static Path file(String name) {
    Path included = INCLUDED.resolve(name);
    return Files.exists(included) ? included : external(name);
  }

  private static Path external(String name) {
    String folder = name.split("/")[0];
    assumeTrue(
        Files.isDirectory(EXTERNAL.resolve(folder)),
        "needs ../shared/reference/%s, which carries no licence (docs/evidence.md)"
            .formatted(folder));
    Path file = EXTERNAL.resolve(name);
    assertFalse(Files.notExists(file), () -> "no reference " + file);
    return file;
  }

  /** Returns all scenario files below a folder, sorted by name. */
  public static List<Path> scenarios(String folder) {
    try (Stream<Path> files = Files.walk(file(folder))) {
      return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the rows of a CSV file without its header. */
  public static List<String[]> rows(String name) {
    try (Stream<String> lines = Files.lines(file(name))) {
      return lines.skip(1).map(line -> line.split(",")).toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
