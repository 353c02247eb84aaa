package org.hificamsim.data;

import java.nio.file.Path;
import java.util.List;

/**
 * A whole CSV table.
 *
 * @param columns the names in its first row
 * @param rows the rows after the first
 */
public record CsvRows(Path file, List<String> columns, List<CsvRow> rows) {}
