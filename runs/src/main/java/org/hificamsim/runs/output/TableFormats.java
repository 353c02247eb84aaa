package org.hificamsim.runs.output;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import org.hificamsim.core.InputException;

/** The formats: text, and those of modules that are on the class path where one is asked for. */
public final class TableFormats {
  /** The one that is always there. */
  public static final String CSV = "csv";

  private static final List<String> NAMES = List.of(CSV, "parquet");

  private TableFormats() {}

  /**
   * The format of this name.
   *
   * @throws InputException when there is none, or its module is not on the class path
   */
  public static TableFormat named(String name) {
    if (!NAMES.contains(name)) {
      throw new InputException(
          "--format is '%s', expected one of %s".formatted(name, String.join(", ", NAMES)));
    }
    return found(name)
        .orElseThrow(
            () ->
                new InputException(
                    "format '%s' is not on the class path, expected its jars in CLASSPATH, or %s"
                        .formatted(name, CSV)));
  }

  /** What wrote a table of a folder; CSV where there is none. */
  static TableFormat of(Path folder, Table<?> table) {
    return NAMES.stream()
        .filter(name -> Files.isRegularFile(folder.resolve(table.file(name))))
        .findFirst()
        .map(name -> reader(name, folder.resolve(table.file(name))))
        .orElseGet(CsvTableFormat::new);
  }

  private static TableFormat reader(String name, Path file) {
    return found(name)
        .orElseThrow(
            () ->
                new InputException(
                    "%s: format '%s' is not on the class path, expected its jars in CLASSPATH, or the files of a run with --format %s"
                        .formatted(file, name, CSV)));
  }

  /** The files that a table may be in. */
  static List<String> files(Table<?> table) {
    return NAMES.stream().map(table::file).toList();
  }

  private static Optional<TableFormat> found(String name) {
    return name.equals(CSV)
        ? Optional.of(new CsvTableFormat())
        : ServiceLoader.load(TableFormat.class).stream()
            .map(ServiceLoader.Provider::get)
            .filter(format -> format.name().equals(name))
            .findFirst();
  }
}
