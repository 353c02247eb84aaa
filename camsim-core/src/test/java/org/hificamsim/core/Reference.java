package org.hificamsim.core;

import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The reference data beside the project; tests that need it skip where it is missing. */
public final class Reference {
  private static final Path ROOT =
      Path.of(System.getProperty("hificamsim.root", "."))
          .resolve("../shared/reference")
          .normalize();

  private Reference() {}

  /** A reference file; the calling test is skipped when there is no reference data. */
  public static Path file(String name) {
    assumeTrue(Files.isDirectory(ROOT), "no reference data at " + ROOT + ": skipped");
    Path file = ROOT.resolve(name);
    return Files.exists(file) ? file : fail("reference data without " + file);
  }

  /** All scenario files below a folder of the reference data; empty where it is missing. */
  public static List<Path> scenarios(String folder) {
    if (!Files.isDirectory(ROOT)) {
      return List.of();
    }
    try (Stream<Path> files = Files.walk(ROOT.resolve(folder))) {
      return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The rows of a reference CSV, without its header. */
  public static List<String[]> rows(String name) {
    try (Stream<String> lines = Files.lines(file(name))) {
      return lines.skip(1).map(line -> line.split(",")).toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
