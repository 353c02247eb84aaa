package org.hificamsim.sqlite;

import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.PreparedStatement;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.Fields;
import org.hificamsim.tracks.format.SqliteReader;
import org.sqlite.SQLiteConfig;
import org.sqlite.SQLiteConnection;
import org.sqlite.SQLiteLimits;
import org.sqlite.SQLiteOpenMode;

/**
 * Reads SQLite files by Xerial's JDBC driver. A file is opened as read-only and immutable, so that
 * no journal is made next to it. Only tables are read, and no views: the query of a view comes from
 * the file, and may never end.
 */
public final class XerialSqlite implements SqliteReader {
  private static final int MAX_VALUE_BYTES = 1 << 20;

  /** Creates a reader, for {@link java.util.ServiceLoader}. */
  public XerialSqlite() {}

  @Override
  public boolean read(Path file, String table, List<String> columns, Consumer<Fields> rows) {
    try (Connection connection = open(file)) {
      Set<String> found = columns(connection, table);
      if (found.isEmpty()) {
        return false;
      }
      requireColumns(file, table, found, columns);
      readRows(connection, file, query(table, columns), rows);
      return true;
    } catch (SQLException e) {
      String reason = String.valueOf(e.getMessage()).lines().findFirst().orElse("");
      throw new InputException(
          new Place(file.toString(), 1, 1)
              .line("cannot be read (" + reason + "), expected a whole SQLite file"),
          e);
    }
  }

  private static Connection open(Path file) throws SQLException {
    SQLiteConfig config = new SQLiteConfig();
    config.setReadOnly(true);
    config.setOpenMode(SQLiteOpenMode.OPEN_URI);
    String path = file.toAbsolutePath().toUri().getRawPath();
    Connection connection =
        DriverManager.getConnection(
            "jdbc:sqlite:file:" + path + "?mode=ro&immutable=1", config.toProperties());
    connection
        .unwrap(SQLiteConnection.class)
        .setLimit(SQLiteLimits.SQLITE_LIMIT_LENGTH, MAX_VALUE_BYTES);
    return connection;
  }

  /** The names of a table's columns; empty if there is no such table. */
  private static Set<String> columns(Connection connection, String table) throws SQLException {
    Set<String> columns = new HashSet<>();
    try (PreparedStatement query =
        connection.prepareStatement(
            "SELECT p.name FROM sqlite_master m, pragma_table_info(m.name) p"
                + " WHERE m.type = 'table' AND m.name = ?")) {
      query.setString(1, table);
      try (ResultSet names = query.executeQuery()) {
        while (names.next()) {
          columns.add(names.getString(1));
        }
      }
    }
    return columns;
  }

  private static void requireColumns(
      Path file, String table, Set<String> found, List<String> columns) {
    if (!found.containsAll(columns)) {
      throw new Place(file.toString(), 1, 1)
          .error(
              "the table %s has the columns %s, expected %s among them",
              table, found.stream().sorted().toList(), String.join(", ", columns));
    }
  }

  private static String query(String table, List<String> columns) {
    return columns.stream()
        .map(column -> '"' + column + '"')
        .collect(Collectors.joining(", ", "SELECT ", " FROM \"" + table + '"'));
  }

  private static void readRows(
      Connection connection, Path file, String query, Consumer<Fields> rows) throws SQLException {
    String name = file.toString();
    try (PreparedStatement statement = connection.prepareStatement(query);
        ResultSet results = statement.executeQuery()) {
      int fields = results.getMetaData().getColumnCount();
      for (int row = 1; results.next(); row++) {
        Object[] values = new Object[fields];
        for (int field = 0; field < fields; field++) {
          values[field] = results.getObject(field + 1);
        }
        rows.accept(new SqliteRow(name, row, values));
      }
    }
  }
}
