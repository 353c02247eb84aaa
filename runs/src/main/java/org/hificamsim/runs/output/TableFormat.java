package org.hificamsim.runs.output;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.IOException;
import java.util.List;
import java.util.ServiceLoader;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Rows;

/**
 * The format in which a run writes its tables: CSV, or one whose module is on the class path. Pages
 * and pictures can be made from CSV only.
 */
public interface TableFormat {
  /** The names of all formats, the default first. */
  List<String> NAMES = List.of("csv", "parquet");

  /** Tables as text. */
  TableFormat CSV = new Csv();

  /** The name of the format, which is also the ending of its files. */
  String name();

  /** Begins a table in a folder. */
  Rows create(Table<?> table, OutputFolder folder) throws IOException;

  /**
   * Returns the format of a name.
   *
   * @throws InputException when there is none, or its module is not on the class path
   */
  static TableFormat named(String name) {
    if (!NAMES.contains(name)) {
      throw InputException.of(
          "%s is '%s', expected one of %s", setting("format"), name, String.join(", ", NAMES));
    }
    return name.equals(CSV.name())
        ? CSV
        : ServiceLoader.load(TableFormat.class).stream()
            .map(ServiceLoader.Provider::get)
            .filter(format -> format.name().equals(name))
            .findFirst()
            .orElseThrow(
                () ->
                    InputException.of(
                        "format '%s' is not on the class path, expected its jars in CLASSPATH, or"
                            + " csv",
                        name));
  }

  /** Comma-separated values. */
  final class Csv implements TableFormat {
    @Override
    public String name() {
      return "csv";
    }

    @Override
    public Rows create(Table<?> table, OutputFolder folder) throws IOException {
      return table.create(folder);
    }
  }
}
