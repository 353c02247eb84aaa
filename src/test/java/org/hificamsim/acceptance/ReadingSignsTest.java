package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests how {@code import} acts on signs that a recording has another unit than was assumed. */
class ReadingSignsTest {
  private static final double WALKING = 1.3; // metres per second

  @TempDir Path folder;
  private int imports;

  /** Returns a recording of two people who walk for 20 samples. */
  private Path walkers(double unitsPerMetre, double timeStep) throws IOException {
    StringBuilder text = new StringBuilder("time,id,x,y\n");
    for (int i = 0; i < 20; i++) {
      for (int id = 1; id <= 2; id++) {
        double x = (10 + WALKING * i) * unitsPerMetre;
        text.append(
            String.format(
                Locale.ROOT, "%s,%d,%.7f,%.7f%n", i * timeStep, id, x, id * unitsPerMetre));
      }
    }
    return Files.writeString(folder.resolve("walkers.csv"), text);
  }

  private Cli imported(Path file, String options) {
    imports++;
    List<Object> words = new ArrayList<>(List.of("import", file, "--out", out()));
    words.addAll(List.of(options.split(" ")));
    return Cli.run(words.toArray());
  }

  private Path out() {
    return folder.resolve("out" + imports);
  }

  private void assertRejected(Path file, String options, String message) {
    Cli refused = imported(file, options);
    refused.assertRejected(message, out());
    Cli forced = imported(file, options + " --force-reading");
    assertEquals(0, forced.exit(), forced.err());
    assertTrue(forced.err().startsWith("warning: "), forced.err());
  }

  private void assertWarned(Path file, String options, String message) {
    Cli imported = imported(file, options);
    assertEquals(0, imported.exit(), imported.err());
    assertTrue(imported.err().contains(message), imported.err());
  }

  private void assertPlausible(Path file, String options) {
    Cli imported = imported(file, options);
    assertEquals(0, imported.exit(), imported.err());
    assertEquals("", imported.err());
  }

  @Test
  void acceptsRightUnitsWithoutWarning() throws IOException {
    assertPlausible(walkers(1, 1), "--unit m");
    assertPlausible(walkers(1000, 1), "--unit mm");
    assertPlausible(walkers(1e-5, 1), "--unit deg");
    assertPlausible(walkers(1, 1), "--unit m --columns frame=time --rate 1.5");
  }

  @Test
  void rejectsTinyStepsAsDegrees() throws IOException {
    assertRejected(
        walkers(1e-5, 1),
        "--unit m",
        "they are probably degrees, expected --unit deg, or --force-reading");
  }

  @Test
  void rejectsInvalidUnitsOfLength() throws IOException {
    assertRejected(walkers(1000, 1), "--unit m", "expected --unit mm, or another --rate");
    assertRejected(walkers(100, 1), "--unit m", "faster than 130 m/s");
    assertRejected(walkers(1, 1), "--unit mm", "expected --unit m, or --columns frame=...");
  }

  @Test
  void rejectsFramesThatAreTimes() throws IOException {
    assertWarned(walkers(0.04, 1), "--unit m", "if times are frames");
    assertRejected(
        walkers(0.04, 0.04),
        "--unit m --columns frame=time --rate 25",
        "most frames are not whole numbers: they are probably seconds, expected --rate 1");
  }

  @Test
  void rejectsTimesInMilliseconds() throws IOException {
    assertRejected(
        walkers(1, 1000),
        "--unit m",
        "expected --unit deg if positions are degrees, or --columns frame=... and --rate 1000 if"
            + " times are milliseconds, or --force-reading");
    assertRejected(
        walkers(100, 1000),
        "--unit cm",
        "expected --unit m, or --columns frame=... and --rate 1000 if times are milliseconds");
    assertPlausible(walkers(1, 1000), "--unit m --columns frame=time --rate 1000");
  }

  @Test
  void rejectsStandingCrowdInCentimetresAsDegrees() throws IOException {
    StringBuilder table = new StringBuilder("time,id,x,y\n");
    for (int i = 0; i < 60; i++) {
      table.append(String.format(Locale.ROOT, "%d,%d,16.370%d,48.2%n", i / 6, i % 6, i % 6));
    }
    Path standing = Files.writeString(folder.resolve("standing.csv"), table);
    assertRejected(standing, "--unit m", "6 targets stand within 0.00050 m, and all positions");
    Path apart =
        Files.writeString(folder.resolve("apart.csv"), table.toString().replace("16.370", "1"));
    assertWarned(apart, "--unit m", "nobody moves: x and y may not be the positions");
  }

  @Test
  void rejectsSeveralRecordingsInOneFile() throws IOException {
    String table = Files.readString(walkers(1, 1));
    String again =
        table.replaceAll("(?m)^(\\d+)\\.0,(\\d),(\\d+)", "$1.5,$2,9$3").replaceFirst(".*\n", "");
    Path both = Files.writeString(folder.resolve("both.csv"), table + again);
    assertRejected(
        both, "--unit m", "another recording probably begins there, expected a file for each");
  }

  @Test
  void warnsIfNobodyIsInViewOfDraftCameras() throws IOException {
    Path walkers = walkers(1, 1);
    assertWarned(walkers, "--unit m --margin 20000", "nobody is in view of the draft cameras");
    assertPlausible(walkers, "--unit m --margin 100");
  }

  @Test
  void rejectsPositionsFromColumnOfFlags() throws IOException {
    StringBuilder text = new StringBuilder("time,id,x,y\n");
    for (int i = 0; i < 20; i++) {
      text.append(i).append(",1,").append(i % 2).append(",0\n");
    }
    Path flags = Files.writeString(folder.resolve("flags.csv"), text);
    assertRejected(
        flags, "--unit m", "x and y have hardly any values but 0, 1: they are probably flags");
  }

  @Test
  void rejectsIdsOfRowsInsteadOfPeople() throws IOException {
    String table = "time,id,x,y\n0,a,0,0\n1,b,1,0\n2,c,2,0\n";
    Path rows = Files.writeString(folder.resolve("rows.csv"), table);
    assertRejected(
        rows, "--unit m", "no target has two samples: the ids are probably those of rows");
  }

  @Test
  void readsColumnsInCapitalsAndIdsWithDecimals() throws IOException {
    String table = "Time,ID,X,Y\n0,1.0,0,0\n1,1,1,0\n2,1.0,2,0\n";
    Path capitals = Files.writeString(folder.resolve("capitals.csv"), table);
    Cli imported = imported(capitals, "--unit m");
    assertEquals(0, imported.exit(), imported.err());
    assertTrue(imported.out().contains("3 samples of 1 targets"), imported.out());
    Path twice = Files.writeString(folder.resolve("twice.csv"), table.replace("ID", "X"));
    imported(twice, "--unit m").assertRejected("two columns have the name", out());
  }

  @Test
  void rejectsManyInvalidRows() throws IOException {
    String table = Files.readString(walkers(1, 1));
    Path odd = Files.writeString(folder.resolve("odd.csv"), table + "21,1,,\n".repeat(5));
    assertRejected(
        odd, "--unit m", "x is '', expected a number from -1e9 to 1e9; 5 of 45 entries are");
    Path few = Files.writeString(folder.resolve("few.csv"), table + "21,1,,\n".repeat(4));
    assertPlausible(few, "--unit m");
  }
}
