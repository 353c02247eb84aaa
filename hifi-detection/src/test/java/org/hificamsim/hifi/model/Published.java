package org.hificamsim.hifi.model;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Reads the published tables. */
final class Published {
  private static final Path FOLDER =
      Path.of(System.getProperty("hificamsim.root"), "src/test/resources/reference/published");

  private Published() {}

  /** Returns the rows of a table, each by column name. */
  static List<Map<String, String>> rows(String table) throws IOException {
    List<String> lines = Files.readAllLines(FOLDER.resolve(table));
    String[] header = lines.get(0).split(",", -1);
    return lines.stream().skip(1).map(line -> row(header, line.split(",", -1))).toList();
  }

  /** Returns the catalogue's spelling of an id of the tables. */
  static String name(String id) {
    return id.replace('_', '-');
  }

  private static Map<String, String> row(String[] header, String[] cells) {
    Map<String, String> row = new LinkedHashMap<>();
    for (int i = 0; i < header.length; i++) {
      row.put(header[i], cells[i]);
    }
    return row;
  }
}
