package org.hificamsim.profiling.report;

import com.fasterxml.jackson.databind.ObjectReader;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.file.Io;

/** Reads the published numbers of the thesis as tables of texts. */
final class PublishedTables {
  private static final ObjectReader CSV =
      new CsvMapper().readerForMapOf(String.class).with(CsvSchema.emptySchema().withHeader());

  private PublishedTables() {}

  /** Returns a row of Table 4.1. */
  static Map<String, String> variable(String id) {
    return find("table-4.1.csv", Map.of("variable", id));
  }

  /** Returns the scores of an f in Table 4.2 and the similar tables of thesis 4.5. */
  static Map<String, String> feature(String f) {
    return find("feature-abstraction.csv", Map.of("id", f.replace('-', '_')));
  }

  /** Returns a detector's line on measured PIP (Eqs 5.2 to 5.4). */
  static Map<String, String> groundTruthLine(String detector) {
    return find("detector-ground-truth-pip.csv", Map.of("detector", detector));
  }

  /** Returns a row of Table 6.1. */
  static Map<String, String> line(String detector, String f) {
    return find("table-6.1.csv", Map.of("detector", detector, "f", f.replace('-', '_')));
  }

  /** Returns a row of Table 6.2. */
  static Map<String, String> camSimLine(String detector) {
    return find("table-6.2.csv", Map.of("detector", detector));
  }

  /** Returns the measurements of Figure 3.7. */
  static List<Map<String, String>> ball() {
    return rows("figure-3.7-ball-at-1m.csv");
  }

  /** Returns the row that contains these cells; empty if there is none. */
  private static Map<String, String> find(String table, Map<String, String> cells) {
    return rows(table).stream()
        .filter(row -> row.entrySet().containsAll(cells.entrySet()))
        .findFirst()
        .orElse(Map.of());
  }

  private static List<Map<String, String>> rows(String table) {
    byte[] csv = Io.resource(PublishedTables.class, table);
    return Io.get(() -> CSV.<Map<String, String>>readValues(csv).readAll());
  }
}
