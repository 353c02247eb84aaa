package org.hificamsim.tracks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.hificamsim.tracks.format.Unit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests files as other programs and countries write them: read, or refused with a remedy. */
class ForeignFilesTest {
  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(strings = {" ", "\t", ";", ","})
  void readsTextOfJuPedSimBetweenAnySeparators(String separator) {
    Imported imported = new Imported(folder).unit(Unit.M);
    imported.read(
        "auto",
        """
        #description: a corridor
        #framerate: 8.00
        #ID FR X Y Z A B ANGLE COLOR
        3 0 1.5 2 0 0.3 0.2 12.0 255
        3 1 2.5 2 0 0.3 0.2 12.0 255
        4 1 9 9 0 0.3 0.2 12.0 255
        """
            .replaceAll("(?m)(?<=^[^#].{0,99}) |(?<=ID.{0,99}|ID) ", separator));
    assertEquals(
        "target 3 size 0.66;0 1.5 2;2.5 2;target 4 size 0.66;0.125 9 9;", imported.tracks());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "5/31/2024 8:00:00|5/31/2024 8:00:01",
        "31/05/2024 08:00:00|31/05/2024 08:00:01",
        "05/06/2024 08:00:00|05/06/2024 08:00:01",
        "5/31/24 11:59:59 PM|6/1/24 12:00:00 AM",
        "31-05-2024 08:00|31-05-2024 08:00:01",
        "8:00:00 AM|8:00:01 AM",
        "00:59.5|01:00.5",
      })
  void readsTimesOfOtherCountries(String first, String second) {
    Imported imported = new Imported(folder).unit(Unit.M);
    imported.read("csv", "time,id,x,y\n%s,1,0,0\n%s,1,1,0\n".formatted(first, second));
    assertEquals("target 1 size 0.66;0 0 0;1 0;", imported.tracks());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "08:00|08:01|expected 00:08:00 if these are minutes and seconds, 08:00:00 if hours",
        "05/06/2024 8:00:00|06/06/2024 8:00:00|expected a date such as 2024-05-31: the file does",
        "05/06/2024 8:00:00|13/06/2024 8:00:00|expected a date such as 2024-05-31: the file does",
        "1.234,5|1.235,5|expected a number without separators of thousands",
      })
  void rejectsAmbiguousTimes(String first, String second, String message) {
    String table = "time;id;x;y\n" + first + ";1;0;0\n" + (second + ";1;1;0\n").repeat(4);
    InputException error =
        assertThrows(
            InputException.class, () -> new Imported(folder).unit(Unit.M).checked("csv", table));
    assertTrue(error.getMessage().contains(message), error::getMessage);
  }

  @ParameterizedTest
  @ValueSource(strings = {"1.234,5", "1,234.5", "1'234,5", "1 234,5"})
  void rejectsSeparatorsOfThousands(String x) {
    InputException error =
        assertThrows(
            InputException.class,
            () -> new Imported(folder).unit(Unit.M).read("csv", "time;id;x;y\n0;1;" + x + ";0\n"));
    String message = "recording:2:5: x is '" + x + "', expected a number from -1e9 to 1e9 without";
    assertTrue(error.getMessage().contains(message), error::getMessage);
  }

  @Test
  void readsMillisecondsThatColumnNames() {
    Imported imported = new Imported(folder).unit(Unit.M).columns(Map.of("time", "t [ms]"));
    imported.read("csv", "t [ms],id,x,y\n0,1,0,0\n500,1,1,0\n1000,1,2,0\n");
    assertEquals("target 1 size 0.66;0 0 0;1 0;2 0;", imported.tracks());
    Imported unix = new Imported(folder).unit(Unit.M).columns(Map.of("time", "timestamp_ms"));
    unix.read("csv", "timestamp_ms,id,x,y\n1700000000000,1,0,0\n1700000000500,1,1,0\n");
    assertEquals("target 1 size 0.66;0 0 0;1 0;", unix.tracks());
  }

  @Test
  void readsUnixTimesInColumnOfFrames() {
    Imported imported = new Imported(folder).unit(Unit.M);
    imported.read("auto", "frame,id,x,y\n1700000000000,1,0,0\n1700000000500,1,1,0\n");
    assertEquals("target 1 size 0.66;0 0 0;1 0;", imported.tracks());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ethucy|0.4 1 0 0~0.8 1 1 0|expected rate=1 if column 1 has seconds",
        "mot|0.4,1,9,9,9,9,1,0,0,0~0.8,1,9,9,9,9,1,1,0,0|a table with times is of the format csv",
        "auto|0.4,1,9,9,9,9,1,0,0,0~0.8,1,9,9,9,9,1,1,0,0|columns=time=1,id=2,x=3,y=4, which",
        "gpx|<gpx><wpt lat='1' lon='2'><time>2024-05-31T12:00:00Z</time></wpt></gpx>"
            + "|<wpt> is a waypoint, expected a <trk> with a <trkseg>, and <trkpt> in it",
        "mot|1,-1,9,9,9,9,1,0,0,0~1,-1,99,9,9,9,1,1,0,0|id is -1, which is a detection of no"
            + " target, expected the tracks that a tracker has made of them",
      })
  void errorsNameTheRemedy(String format, String content, String message) {
    Imported imported = new Imported(folder);
    if (!format.equals("gpx")) {
      imported.unit(Unit.M);
    }
    if (content.contains("-1")) {
      imported.rate(10);
    }
    InputException error =
        assertThrows(InputException.class, () -> imported.read(format, content.replace('~', '\n')));
    assertTrue(error.getMessage().contains(message), error::getMessage);
  }

  @Test
  void rejectsColumnOfLatitudesForX() {
    Imported imported = new Imported(folder).unit(Unit.DEG).columns(Map.of("x", "Lat", "y", "Lon"));
    InputException error =
        assertThrows(
            InputException.class, () -> imported.read("csv", "time,id,Lat,Lon\n0,1,48.2,16.3\n"));
    assertTrue(
        error.getMessage().contains(":1:9: x is the column 'lat', expected the longitude"),
        error::getMessage);
  }

  @Test
  void leavesOutDetectionsAmongTracks() {
    Imported imported = new Imported(folder).unit(Unit.M).rate(10);
    ImportSummary found =
        imported.read("mot", "1,3,9,9,9,9,1,0,0,0\n1,-1,9,9,9,9,1,5,0,0\n2,3,9,9,9,9,1,1,0,0\n");
    assertEquals("target 3 size 0.66;0 0 0;1 0;", imported.tracks());
    assertTrue(
        found.lines().toString().contains("left out: 1 entry without an id"),
        found.lines()::toString);
  }

  @Test
  void keepsDigitsFarFromOrigin() {
    Imported imported = new Imported(folder).unit(Unit.M);
    ImportSummary found =
        imported.read(
            "csv", "time,id,x,y\n0,1,32601234.567,5340987.123\n1,1,32601235.068,5340988\n");
    assertEquals(
        "target 1 size 0.66;0 32601234.567 5340987.123;32601235.068 5340988;", imported.tracks());
    assertTrue(
        found
            .lines()
            .contains(
                "places: x from 32601234.567 to 32601235.068 m, y from 5340987.123 to 5340988 m"),
        found.lines()::toString);
  }
}
