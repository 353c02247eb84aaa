package org.hificamsim.sqlite;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.hificamsim.cli.Main;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code import} of JuPedSim's SQLite files. */
class SqliteImportTest {
  private static final String TRAJECTORY =
      "CREATE TABLE trajectory_data (frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL,"
          + " pos_y REAL, ori_x REAL, ori_y REAL)";
  private static final String METADATA =
      "CREATE TABLE metadata(key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL)";
  private static final String FPS = "INSERT INTO metadata VALUES ('version', '2'), ('fps', '10.0')";

  @TempDir Path folder;
  private final StringWriter printed = new StringWriter();
  private final StringWriter errors = new StringWriter();

  private Path database(String... statements) throws SQLException {
    Path file = folder.resolve("a walk #1.sqlite");
    try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file);
        Statement statement = connection.createStatement()) {
      for (String text : statements) {
        statement.execute(text);
      }
    }
    return file;
  }

  private Path walk() throws SQLException {
    List<String> rows = new ArrayList<>();
    for (int frame = 0; frame < 50; frame++) {
      rows.add("(%s, 3, %s, 2.5, 1, 0)".formatted(frame, 1 + 0.125 * frame));
      rows.add("(%s, 4, 9, %s, 0, 1)".formatted(frame, 0.125 * frame));
    }
    String insert = "INSERT INTO trajectory_data VALUES " + String.join(", ", rows);
    return database(METADATA, FPS, TRAJECTORY, insert);
  }

  private int importFile(Path file, Object... more) {
    List<Object> words = new ArrayList<>(List.of("import", file, "--out", folder.resolve("out")));
    words.addAll(List.of(more));
    return Main.execute(
        new PrintWriter(printed, true),
        new PrintWriter(errors, true),
        words.stream().map(Object::toString).toArray(String[]::new));
  }

  private void assertRejects(Path file, String message) {
    assertEquals(2, importFile(file, "--format", "jupedsim"));
    assertTrue(errors.toString().contains(message), errors::toString);
  }

  @Test
  void readsWalkableAreaAsWalls() throws SQLException, IOException {
    Path file = walk();
    try (Connection connection = DriverManager.getConnection("jdbc:sqlite:" + file);
        Statement statement = connection.createStatement()) {
      statement.execute("CREATE TABLE geometry (hash INTEGER NOT NULL, wkt TEXT NOT NULL)");
      statement.execute(
          "INSERT INTO geometry VALUES (1, 'GEOMETRYCOLLECTION (POLYGON ((0 -1, 10 -1, 10 9, 0 9,"
              + " 0 -1), (4 5, 5 5, 5 6, 4 5)))')");
    }
    assertEquals(0, importFile(file, "--walls", file), errors::toString);
    assertTrue(printed.toString().contains("walls and solids: 7"), printed::toString);
    assertEquals("", errors.toString());
  }

  @Test
  void readsTrajectoriesAtRateOfFile() throws SQLException, IOException {
    assertEquals(0, importFile(walk()), errors::toString);
    String out = printed.toString();
    assertTrue(out.contains("format: jupedsim (a walk #1.sqlite is an SQLite file)"), out);
    assertTrue(out.contains("100 samples of 2 targets in 4.9 s"), out);
    assertTrue(out.contains("half up to 1.25"), out);
    String tracks = Files.readString(folder.resolve("out/a-walk--1.tracks"));
    assertTrue(tracks.contains("target 3 size 0.66\n0 1 2.5\n1.125 2.5\n"), tracks);
  }

  @Test
  void changesNeitherFileNorFolder() throws SQLException, IOException {
    Path file = walk();
    byte[] before = Files.readAllBytes(file);
    assertEquals(0, importFile(file));
    assertEquals(List.of("a walk #1.sqlite", "out"), names());
    assertTrue(Arrays.equals(before, Files.readAllBytes(file)));
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  @Test
  void omitsRowsWithoutPosition() throws SQLException {
    Path file =
        database(
            METADATA,
            FPS,
            TRAJECTORY,
            "INSERT INTO trajectory_data VALUES (0, 1, 1, 1, 0, 0), (1, 1, NULL, 1, 0, 0)");
    assertEquals(0, importFile(file), errors::toString);
    String line = "left out: 1 entry without a place, the first at " + file + ":2:3: pos_x is ''";
    assertTrue(printed.toString().contains(line), printed::toString);
  }

  @Test
  void rejectsOtherDatabases() throws SQLException {
    assertRejects(database("CREATE TABLE a (b)"), "expected the table trajectory_data of JuPedSim");
    assertRejects(
        database("CREATE TABLE trajectory_data (frame, id, x, y)"),
        "the table trajectory_data has the columns [frame, id, x, y], expected frame, id, pos_x");
  }

  @Test
  void reportsMissingRate() throws SQLException {
    assertRejects(
        database(TRAJECTORY, "INSERT INTO trajectory_data VALUES (0, 1, 1, 1, 0, 0)"),
        "expected --rate R, the frames per second");
  }

  /** The query of a view may return rows without end. */
  @Test
  void ignoresViews() throws SQLException {
    Path file =
        database(
            METADATA,
            FPS,
            "CREATE VIEW trajectory_data AS WITH RECURSIVE n(frame) AS (SELECT 1 UNION ALL SELECT"
                + " frame + 1 FROM n) SELECT frame, 1 AS id, frame AS pos_x, 1 AS pos_y FROM n");
    assertRejects(file, "expected the table trajectory_data of JuPedSim");
  }

  @Test
  void readsOrRejectsDamagedFiles() throws SQLException, IOException {
    byte[] right = Files.readAllBytes(walk());
    Random random = new Random(5);
    for (int i = 0; i < 100; i++) {
      byte[] broken = right.clone();
      for (int flips = 0; flips <= i / 10; flips++) {
        int offset = 16 + random.nextInt(broken.length - 16);
        broken[offset] = (byte) random.nextInt(256);
      }
      Path file = folder.resolve("broken" + i + ".sqlite");
      Files.write(file, i % 10 == 0 ? Arrays.copyOf(broken, 5000) : broken);
      int exit = importFile(file, "--force-reading");
      assertTrue(exit == 0 || exit == 2, () -> exit + errors.toString());
      assertTrue(!errors.toString().contains("Exception"), errors::toString);
    }
  }
}
