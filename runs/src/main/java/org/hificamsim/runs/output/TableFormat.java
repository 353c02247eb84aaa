package org.hificamsim.runs.output;

import static org.hificamsim.core.NamedSetting.setting;

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

/**
 * How the tables of a run are written, {@code --format}: as text, or as a module does that is on
 * the class path where its format is asked for.
 */
public interface TableFormat {
  /** All names: text comes first. */
  List<String> NAMES = List.of("csv", "parquet");

  /** Tables as text, which everything reads. */
  TableFormat CSV = new Csv();

  /** Its name, which files end in. */
  String name();

  /** Starts a table in a folder. */
  Rows create(Table<?> table, OutputFolder folder) throws IOException;

  /**
   * Reads a table of numbers, row by row as CSV has it, without the header.
   *
   * @throws InputException when it is no file of this format
   */
  void each(Path file, Consumer<String> row) throws IOException;

  /**
   * The format of this name.
   *
   * @throws InputException when there is none, or its module is not on the class path
   */
  static TableFormat named(String name) {
    if (!NAMES.contains(name)) {
      throw InputException.of(
          "%s is '%s', expected one of %s", setting("format"), name, String.join(", ", NAMES));
    }
    return found(name, "", "");
  }

  /** What wrote a table of a folder; CSV where there is none. */
  static TableFormat of(Path folder, Table<?> table) {
    return NAMES.stream()
        .filter(name -> Files.isRegularFile(folder.resolve(table.file(name))))
        .findFirst()
        .map(
            name -> {
              String file = folder.resolve(table.file(name)) + ": ";
              return found(name, file, "the files of a run with format ");
            })
        .orElse(CSV);
  }

  private static TableFormat found(String name, String file, String instead) {
    return name.equals(CSV.name())
        ? CSV
        : ServiceLoader.load(TableFormat.class).stream()
            .map(ServiceLoader.Provider::get)
            .filter(format -> format.name().equals(name))
            .findFirst()
            .orElseThrow(
                () ->
                    InputException.of(
                        "%sformat '%s' is not on the class path, expected its jars in CLASSPATH, or"
                            + " %scsv",
                        file, name, instead));
  }

  /** Text. */
  final class Csv implements TableFormat {
    @Override
    public String name() {
      return "csv";
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
