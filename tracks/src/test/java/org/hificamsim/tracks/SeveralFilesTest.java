package org.hificamsim.tracks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
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

/** Tests several files in one import, files without ids, and times in place of frames. */
class SeveralFilesTest {
  @TempDir Path folder;

  @Test
  void continuesTargetsOfLaterFiles() {
    Imported imported = new Imported(folder).rate(1);
    ImportSummary found =
        imported.readAll("ethucy", "5 1 5 0\n6 1 6 0\n6 2 9 9\n", "0 1 0 0\n1 1 1 0\n2 1 2 0\n");
    assertEquals(
        "target 1 size 0.66;0 0 0;1 0;2 0;5 5 0;6 0;target 2 size 0.66;6 9 9;", imported.tracks());
    assertTrue(found.lines().contains("ids: the same in all files"), found.lines()::toString);
  }

  @Test
  void keepsApartIdsThatAreInTwoFilesAtOnce() {
    Imported imported = new Imported(folder).rate(1);
    ImportSummary found = imported.readAll("ethucy", "0 1 0 0\n1 1 1 0\n", "0 1 5 0\n1 1 5 1\n");
    assertEquals("target 1 size 0.66;0 0 0;1 0;target 2 size 0.66;0 5 0;5 1;", imported.tracks());
    assertTrue(
        found.lines().toString().contains("ids: each file has its own"), () -> "" + found.lines());
  }

  @Test
  void eachFileWithoutIdsHasOneTarget() {
    Imported imported = new Imported(folder).unit(Unit.M);
    ImportSummary found =
        imported.readAll("csv", "time,x,y\n0,0,0\n1,1,0\n", "time,x,y\n2,5,0\n3,6,0\n");
    assertEquals("target 1 size 0.66;0 0 0;1 0;target 2 size 0.66;2 5 0;6 0;", imported.tracks());
    assertFalse(found.lines().toString().contains("ids:"), found.lines()::toString);
  }

  @Test
  void readsFilesInSeveralFormats() {
    Imported imported = new Imported(folder).unit(Unit.M).rate(10);
    imported.readAll("auto", "time,id,x,y\n0,7,0,0\n1,7,1,0\n", "8 0 1 1 1\n8 10 1 2 1\n");
    assertEquals("target 7 size 0.66;0 0 0;1 0;target 8 size 0.66;0 1 1;1 2;", imported.tracks());
  }

  @Test
  void reportsThatATableWithoutIdsHasOneTarget() {
    Imported imported = new Imported(folder).unit(Unit.M).columns(Map.of("time", "t"));
    ImportSummary found = imported.read("csv", "t,x,y\n0,0,0\n1,1,0\n");
    assertTrue(found.lines().contains("ids: none, all samples are of one target"));
    InputException error =
        assertThrows(
            InputException.class, () -> imported.read("csv", "t,who,x,y\n0,1,0,0\n0,2,1,0\n"));
    assertTrue(
        error.getMessage().contains("no column id, expected columns=id=NAME if they are"),
        error::getMessage);
  }

  @Test
  void endsTracksBetweenPartsThatAreClose() {
    Imported imported = new Imported(folder);
    imported.read(
        "gpx",
        """
        <gpx><trk><trkseg>
        <trkpt lat="48" lon="11"><time>2024-05-31T12:00:00Z</time></trkpt>
        <trkpt lat="48" lon="11"><time>2024-05-31T12:00:10Z</time></trkpt>
        </trkseg><trkseg>
        <trkpt lat="48" lon="11"><time>2024-05-31T12:00:20Z</time></trkpt>
        </trkseg><trkseg>
        <trkpt lat="48" lon="11"><time>2024-05-31T12:00:20Z</time></trkpt>
        <trkpt lat="48" lon="11"><time>2024-05-31T12:00:30Z</time></trkpt>
        </trkseg></trk></gpx>
        """);
    assertEquals("target 1 size 0.66;0 0 0;0 0;target 1 size 0.66;20 0 0;0 0;", imported.tracks());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "ethucy|12:00:00 1 0 0;12:00:01 1 1 0",
        "ethucy|1700000000 1 0 0;1700000001 1 1 0",
        "ethucy|2024-05-31T23:59:59 1 0 0;2024-06-01T00:00:00 1 1 0",
        "petrack|1 1700000000000 0 0;1 1700000001000 1 0",
        "mot|12:00:00,1,9,9,9,9,1,0,0,0;12:00:01,1,9,9,9,9,1,1,0,0",
        "fcd|<fcd-export><timestep time='1:00:00:00'><person id='1' x='0' y='0'/></timestep>"
            + "<timestep time='1:00:00:01'><person id='1' x='1' y='0'/></timestep></fcd-export>",
        "csv|time,id,x,y;23:59:59.5,1,0,0;00:00:00.5,1,1,0",
        "csv|time;id;x;y~1700000000,5;1;0;0~1700000001,5;1;1;0",
      })
  void readsTimesInEveryFormat(String format, String content) {
    boolean isMetric = !format.equals("fcd");
    Imported imported = new Imported(folder);
    ImportSummary found =
        (isMetric ? imported.unit(Unit.M) : imported)
            .read(
                format,
                content.contains("~") ? content.replace('~', '\n') : content.replace(';', '\n'));
    assertEquals("target 1 size 0.66;0 0 0;1 0;", imported.tracks());
    assertEquals(1, found.interval());
  }

  @Test
  void rejectsRoutes() {
    InputException error =
        assertThrows(
            InputException.class,
            () ->
                new Imported(folder)
                    .read(
                        "auto",
                        "<gpx><rte><rtept lat='1' lon='2'/></rte><wpt lat='1' lon='2'/></gpx>"));
    assertTrue(error.getMessage().contains("<rte> is a route, not a track"), error::getMessage);
  }

  @Test
  void leavesOutFurtherPredictions() {
    Imported imported = new Imported(folder);
    ImportSummary found =
        imported.read(
            "auto",
            """
            {"scene": {"id": 0, "p": 7, "s": 0, "e": 10, "fps": 2.5}}
            {"track": {"f": 0, "p": 7, "x": 1, "y": 2}}
            {"track": {"f": 10, "p": 7, "x": 1.5, "y": 2, "prediction_number": 0, "scene_id": 0}}
            {"track": {"f": 10, "p": 7, "x": 1.7, "y": 2, "prediction_number": 1, "scene_id": 0}}
            {"track": {"f": 20, "p": 7, "x": null, "y": 2}}
            """);
    assertEquals("target 7 size 0.66;0 1 2;1.5 2;", imported.tracks());
    assertTrue(found.lines().toString().contains("left out: 1 entry that the file marks"));
  }
}
