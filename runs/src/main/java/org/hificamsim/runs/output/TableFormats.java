package org.hificamsim.runs.output;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.ServiceLoader;
import java.util.function.Consumer;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Rows;

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
      throw InputException.of(
          "--format is '%s', expected one of %s", name, String.join(", ", NAMES));
    }
    return found(name, "", "");
  }

  /** What wrote a table of a folder; CSV where there is none. */
  static TableFormat of(Path folder, Table<?> table) {
    return NAMES.stream()
        .filter(name -> Files.isRegularFile(folder.resolve(table.file(name))))
        .findFirst()
        .map(
            name ->
                found(
                    name,
                    folder.resolve(table.file(name)) + ": ",
                    "the files of a run with --format "))
        .orElseGet(Csv::new);
  }

  /** The files that a table may be in. */
  static List<String> files(Table<?> table) {
    return NAMES.stream().map(table::file).toList();
  }

  private static TableFormat found(String name, String file, String instead) {
    return name.equals(CSV)
        ? new Csv()
        : ServiceLoader.load(TableFormat.class).stream()
            .map(ServiceLoader.Provider::get)
            .filter(format -> format.name().equals(name))
            .findFirst()
            .orElseThrow(
                () ->
                    InputException.of(
                        "%sformat '%s' is not on the class path, expected its jars in CLASSPATH, or"
                            + " %s%s",
                        file, name, instead, CSV));
  }

  /** Tables as text, which everything reads. */
  private static final class Csv implements TableFormat {
    @Override
    public String name() {
      return CSV;
    }

    @Override
    public Rows create(Table<?> table, OutputFolder folder) throws IOException {
      return table.create(folder);
    }

    @Override
    public void each(Path file, Consumer<String> row) throws IOException {
      try (InputStream in = Files.newInputStream(file);
          BufferedReader reader = // that takes any byte: what is wrong is said with its place
              new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8), 1 << 16)) {
        reader.readLine();
        for (String line; (line = reader.readLine()) != null; ) {
          row.accept(line);
        }
      }
    }
  }
}
