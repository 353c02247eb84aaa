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

/** Tests each format with a small file. */
class FormatsTest {
  private static final String GPX =
      """
      <gpx xmlns="http://www.topografix.com/GPX/1/1"><trk><name>Bus</name><trkseg>
      <trkpt lat="48.2" lon="16.37"><ele>170</ele><time>2024-05-31T12:00:00Z</time></trkpt>
      <trkpt lat="48.2009" lon="16.37"><time>2024-05-31T12:00:10.5Z</time></trkpt>
      </trkseg></trk></gpx>
      """;

  @TempDir Path folder;

  @Test
  void readsObsmat() {
    Imported imported = new Imported(folder).rate(25);
    ImportSummary found =
        imported.read(
            "obsmat",
            """
               1.000000e+00   1.000000e+00  -2.829260e+00   0.0e+00   1.895935e+01   0 0 -1.3
               1.100000e+01   1.000000e+00  -2.829260e+00   9.0e+00   1.843074e+01   0 0 -1.3
               1.100000e+01   2.000000e+00  3 0 4 0 0 0
            """);
    assertEquals(
        "target 1 size 0.66;0 -2.829 18.959;-2.829 18.431;target 2 size 0.66;0.4 3 4;",
        imported.tracks());
    assertEquals(0.4, found.interval());
  }

  @Test
  void readsEthUcySeparatedByTabsAndSpaces() {
    Imported imported = new Imported(folder).rate(2.5);
    imported.read("ethucy", "10\t1.0\t2.5\t3\n11\t1.0\t 3.5 4\n");
    assertEquals("target 1 size 0.66;0 2.5 3;3.5 4;", imported.tracks());
  }

  @Test
  void countsTrajNetSamplesBySceneRate() {
    Imported imported = new Imported(folder);
    ImportSummary found = imported.read("trajnet", trajNet());
    assertEquals("target 7 size 0.66;0 1 2;1.5 2;2 2;", imported.tracks());
    assertEquals(0.4, found.interval());
  }

  @Test
  void countsTrajNetFramesByGivenRate() {
    Imported imported = new Imported(folder).rate(6);
    assertEquals(1, imported.read("trajnet", trajNet()).interval());
  }

  private static String trajNet() {
    return """
           {"scene": {"id": 0, "p": 7, "s": 6, "e": 18, "fps": 2.5, "tag": [1, [2]]}}
           {"track": {"f": 6, "p": 7, "x": 1.0, "y": 2.0}}
           {"track": {"f": 12, "p": 7, "x": 1.5, "y": 2.0}}
           {"track": {"f": 18, "p": 7, "x": 2.0, "y": 2.0, "prediction_number": 0}}
           """;
  }

  @Test
  void readsMotPositionsInWorld() {
    Imported imported = new Imported(folder).rate(10).unit(Unit.CM);
    ImportSummary found =
        imported.read(
            "mot", "1,3,10,20,30,60,1,100,250,0\n2,3,10,20,30,60,1,200,250,0\n2,4,0,0,1,1,0,5,5,0");
    assertEquals("target 3 size 0.66;0 1 2.5;2 2.5;", imported.tracks());
    assertEquals(0, found.targetsWithSize());
  }

  @Test
  void convertsMotBoxesByHomography() {
    Imported imported =
        new Imported(folder).rate(10).unit(Unit.PX).homography("0.1 0 0\n0 -0.1 50\n0 0 1\n");
    ImportSummary found = imported.read("mot", "1,3,100,20,10,40,1,-1,-1,-1\n");
    assertEquals("target 3 width 1 height 4;0 10.5 44;", imported.tracks());
    assertEquals(1, found.targetsWithSize());
  }

  @Test
  void readsMotRowsThatEndWithBox() {
    Imported imported =
        new Imported(folder).rate(10).unit(Unit.PX).homography("1 0 0\n0 1 0\n0 0 1\n");
    imported.read("mot", "1,3,100,20,10,40\n2,3,110,20,0,0\n");
    assertEquals("target 3 width 10 height 40;0 105 60;110 20;", imported.tracks());
  }

  @Test
  void rejectsMotBoxesWithoutHomography() {
    assertRejected(
        new Imported(folder).rate(10).unit(Unit.M),
        "mot",
        "1,3,100,20,10,40,1,-1,-1,-1\n",
        ":1:1: the row has no position in the world, expected unit=px and homography=FILE");
    assertRejected(
        new Imported(folder).rate(10).unit(Unit.PX),
        "mot",
        "1,3,100,20,10,40,1\n",
        "positions are pixels, expected homography=FILE");
  }

  @Test
  void ignoresClassAndVisibilityOfMot16() {
    Imported imported =
        new Imported(folder).rate(10).unit(Unit.PX).homography("1 0 0\n0 1 0\n0 0 1\n");
    imported.read("mot", "1,3,100,20,10,40,1,1,0.9\n");
    assertEquals("target 3 width 10 height 40;0 105 60;", imported.tracks());
  }

  @Test
  void readsRateAndUnitOfPeTrack() {
    Imported imported = new Imported(folder);
    imported.read(
        "petrack",
        "# PeTrack\n"
            + "# framerate: 16.00 fps\n"
            + "# id frame x/cm y/cm z/cm\n"
            + "1 0 100 200 170\n"
            + "1 4 150 200 171\n");
    assertEquals("target 1 size 0.66;0 1 2;1.5 2;", imported.tracks());
  }

  @Test
  void requiresRateAndUnitForPeTrackWithoutHeader() {
    assertRejected(
        new Imported(folder).unit(Unit.M), "petrack", "1 0 1 2\n", "expected rate=R, the frames");
    assertRejected(
        new Imported(folder).rate(16), "petrack", "1 0 1 2 3\n", "expected unit, one of m, cm");
  }

  @Test
  void readsFloatingCarDataInSecondsAndMetres() {
    Imported imported = new Imported(folder);
    imported.read(
        "fcd",
        """
<?xml version="1.0" encoding="UTF-8"?>
<fcd-export xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance">
  <timestep time="5.00"><vehicle id="north.0" x="1" y="2" angle="0" speed="5"/>
    <person id="walker" x="7" y="8" angle="90" speed="1"/></timestep>
  <timestep time="5.50"><vehicle id="north.0" x="1" y="4.5" angle="0" speed="5"/></timestep>
</fcd-export>
""");
    assertEquals("target 1 size 0.66;0 1 2;1 4.5;target 2 size 0.66;0 7 8;", imported.tracks());
  }

  /** 0.0009 degrees of latitude are 100.075 m at 48.2 degrees (WGS84). */
  @Test
  void projectsGpxToMetres() {
    Imported imported = new Imported(folder);
    imported.read("gpx", GPX);
    assertEquals("target 1 size 0.66;0 0 0;0 100.075;", imported.tracks());
  }

  @Test
  void rejectsGpxWithoutTimes() {
    assertRejected(
        new Imported(folder),
        "gpx",
        GPX.replaceAll("<time>.*?</time>", ""),
        ": <trkpt> has no <time>, expected one");
    assertRejected(
        new Imported(folder),
        "gpx",
        GPX.replaceAll("12:00:.*Z", "noon"),
        ": <time> is '2024-05-31Tnoon', expected a time: seconds, a Unix time, as 2024-05-31T12");
  }

  @Test
  void readsFloatingCarDataInDegrees() {
    Imported imported = new Imported(folder).unit(Unit.DEG);
    imported.read(
        "fcd",
        "<f><timestep time='0'><person id='a' x='16' y='48'/></timestep>"
            + "<timestep time='1'><person id='a' x='16.001' y='48'/></timestep></f>");
    assertEquals("target 1 size 0.66;0 0 0;74.625 0;", imported.tracks());
  }

  @Test
  void readsFractionsOfSeconds() {
    assertEquals(10.5, new Imported(folder).read("gpx", GPX).interval());
  }

  @Test
  void readsColumnsByNameAndNumber() {
    Imported imported = new Imported(folder).unit(Unit.M).columns(Map.of("x", "4", "y", "north"));
    imported.read("csv", "time,id,north,east,width,height\n0,1,2,3,1e9,1\n");
    assertEquals("target 1 width 1000000000 height 1;0 3 2;", imported.tracks());
    assertRejected(
        new Imported(folder).unit(Unit.M).columns(Map.of("x", "5", "y", "y")),
        "csv",
        "time,id,y,z\n0,1,2,3\n",
        ":1:1: no column '5' for x, expected columns with it, of: time, id, y, z");
    assertRejected(
        new Imported(folder).unit(Unit.M).columns(Map.of("z", "4")),
        "csv",
        "time,id,x,y\n0,1,2,3\n",
        "columns has 'z', expected time or frame, id, x, y, width, height");
  }

  @Test
  void ignoresGeoJsonFeaturesWithoutPositions() {
    Imported imported = new Imported(folder).unit(Unit.M);
    imported.read(
        "geojson",
        """
{"features": [
  {"geometry": null, "properties": null},
  {"id": "a", "geometry": {"type": "LineString", "coordinates": [[1, 2], [3, 2]]},
   "properties": {"name": "b", "coordinateProperties": {"times": [0, 2], "speeds": [1, 1]}}}]}
""");
    assertEquals("target 1 size 0.66;0 1 2;3 2;", imported.tracks());
  }

  @Test
  void readsGeoJsonLines() {
    Imported imported = new Imported(folder).unit(Unit.M);
    imported.read(
        "geojson",
        """
        {"type": "FeatureCollection", "features": [{"type": "Feature",
          "properties": {"id": 5, "coordTimes": ["2024-05-31T12:00:00Z", "2024-05-31T12:00:02Z"]},
          "geometry": {"type": "LineString", "coordinates": [[1, 2, 99], [3, 2]]}}]}
        """);
    assertEquals("target 5 size 0.66;0 1 2;3 2;", imported.tracks());
  }

  @Test
  void readsGeoJsonPoints() {
    Imported imported = new Imported(folder).unit(Unit.M).columns(Map.of("id", "who"));
    imported.read(
        "geojson",
        """
        {"features": [
          {"properties": {"who": "a", "time": 3}, "geometry": {"coordinates": [1, 2]}},
          {"properties": {"who": "a", "time": 4}, "geometry": {"coordinates": [2, 2]}}]}
        """);
    assertEquals("target 1 size 0.66;0 1 2;2 2;", imported.tracks());
  }

  @Test
  void rejectsGeoJsonWithoutTimes() {
    assertRejected(
        new Imported(folder),
        "geojson",
        "{\"features\": [{\"geometry\": {\"coordinates\": [[1, 2], [3, 4]]}}]}",
        ":1:15: the feature has 2 positions and 0 times, expected the same number");
  }

  @Test
  void readsColumnsByName() {
    Imported imported =
        new Imported(folder)
            .unit(Unit.MM)
            .columns(
                Map.of(
                    "time", "t", "id", "who", "x", "east", "y", "north", "width", "w", "height",
                    "h"));
    imported.read(
        "csv",
        "north;east;\"who\";t;w;h\n1000;2000;\"a;b\";0,5;1;1\n".replace("0,5", "0.5")
            + "1000;3000;\"a;b\";1;1;1\n");
    assertEquals("target 1 width 0.001 height 0.001;0 2 1;3 1;", imported.tracks());
  }

  @Test
  void readsColumnsByNumber() {
    Imported imported =
        new Imported(folder)
            .unit(Unit.M)
            .rate(2)
            .columns(Map.of("frame", "1", "id", "2", "x", "3", "y", "4"));
    imported.read("csv", "0,1,2,3\n1,1,2.5,3\n");
    assertEquals("target 1 size 0.66;0 2 3;2.5 3;", imported.tracks());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "obsmat|1 1 1 0 1 0 0|:1:1: rows have 7 columns, ETH/UCY has 8, expected a file in",
        "obsmat|1,1,1,0,1,0,0,0|:1:1: columns are separated by commas, ETH/UCY has blanks",
        "ethucy|2 1 1 1;2 1 1 5|:2:1: target 1 is at two places at time 2.0, expected one sample",
        "ethucy|1 1 1e10 1|:1:5: x is '1e10', expected a number from -1e9 to 1e9",
        "ethucy|1 1 0x1p3 1|:1:5: x is '0x1p3'",
        "ethucy||:1:1: the file is empty, ETH/UCY has rows of numbers",
        "mot|1,1,0,0,-5,5,1,1,1,0|:1:9: width is '-5', expected a number of pixels from 0",
        "mot|1;1;0;0;5;5|:1:1: the row has no position in the world",
        "trajnet|{\"track\": {\"f\": 1, \"p\": 1, \"x\": NaN, \"y\": 1}}|:1:11: the track has no"
            + " number x",
        "trajnet|{\"track\": {\"f\": 1, \"p\": 1, \"x\": 1}}|:1:11: the track has no number y",
        "trajnet|{\"track\": {\"f\": 1, \"p\"|:1:23: the file ends too early",
        "trajnet|[1]|:1:1: the file is JSON, TrajNet++ has lines {\"track\": {...}}, expected a"
            + " file",
        "fcd|<f><timestep time='1'><vehicle id='a' x='1'/></timestep></f>|<vehicle> has no y",
        "fcd|<fcd-export><vehicle id='a' x='1' y='2'/></fcd-export>|<vehicle> outside <timestep",
        "fcd|<f><timestep time='1'><vehicle id='a' x='1' y='2'/>|cut off",
        "fcd|<!DOCTYPE f []><fcd-export/>|not well-formed XML",
        "fcd|<f><timestep time='x'><person/></timestep></f>|<timestep> time is 'x', expected a"
            + " time",
        "trajnet|{\"track\": {\"f\": 1, \"p\": 1, \"x\": 1e10, \"y\": 1}}|:1:11: x is '1.0E10'",
        "trajnet|{\"scene\": {\"fps\": 0}}|:1:19: fps is '0', expected a number above 0",
        "trajnet|{\"scene\": {\"fps\": 2}} {\"scene\": {\"fps\": 3}}|expected 2.0 as before",
        "petrack|# framerate: 5;;# x/cm|:1:1: the file is empty, PeTrack has rows of numbers",
        "csv|time,id,x,y;0,1,2|:2:1: the row has 3 cells, expected 4",
        "csv|time,id,x,y;0,1,2 ,;|:2:8: y is '', expected a number",
        "csv|when,id,x,y;0,1,2,3|:1:1: no column 'time' for time, expected columns with it, of:",
      })
  void rejectsInvalidInputWithItsPlace(String format, String content, String message) {
    Imported imported = new Imported(folder).rate(1);
    String text = content == null ? "" : content.replace(';', '\n');
    assertRejected(
        format.equals("fcd") ? new Imported(folder) : imported.unit(Unit.M),
        format,
        format.equals("mot") && content.contains("1;1;0") ? content : text,
        message);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "obsmat|1 1 1 0 1 0 0 0;2 1 NaN 0 1 0 0 0|without a place|:2:5: x is 'NaN', expected",
        "obsmat|1 1 1 0 1 0 0 0;2 1 1 0|without a place|:2:8: the line has no y, expected",
        "obsmat|1 1 1 0 1 0 0 0;2 1 1 0 2|with another number of columns|:2:10: the line has no",
        "ethucy|1 1 1 1;2;3 1 1 1|without an id|:2:2: the line has no id",
        "ethucy|1 1 1 1;x 1 2 2|without a time|:2:1: frame is 'x', expected a finite number",
        "ethucy|1 1 1 1;2 1 ? ?|whose place is unknown|:2:5: x is '?', expected a number",
        "mot|1,1,0,0,5,5,1,1,1,0;2,1,0,0,5,5,1|with another number of columns|:2:13: the line",
        "mot|1,1,0,0,5,5,1,1,1,0;2,1,0,0,5,5,0,9,9,0|marks as not to be used|:2:1: confidence",
        "csv|time,id,x,y;0,1,2,3;1,,3,3|without an id|:3:3: id is '', expected a name or number",
        "csv|time,id,x,y;0,1,2,3;1,1,,3|without a place|:3:5: x is '', expected a number from",
        "csv|time,id,x,y;0,1,2,3;1,,,|with neither id nor place|:3:3: id is '', expected a name",
        "csv|time,id,x,y;s,,m,m;0,1,2,3|without an id|:2:3: id is '', expected a name or number",
        "csv|time,id,x,y;0,1,2,3;1,1|with another number of columns|:3:1: the row has 2 cells",
        "petrack|1 1 1 1;1 2 nan nan|without a place|:2:5: x is 'nan', expected a number",
      })
  void leavesOutOddRowsAndReportsTheFirst(
      String format, String content, String kind, String first) {
    Imported imported = new Imported(folder).rate(1).unit(Unit.M);
    ImportSummary found = imported.read(format, content.replace(';', '\n'));
    String line =
        found.lines().stream()
            .filter(text -> text.startsWith("left out: 1 entry "))
            .findAny()
            .get();
    assertTrue(line.contains(kind) && line.contains(first), line);
  }

  @Test
  void ignoresInvalidSizes() {
    Imported imported = new Imported(folder).unit(Unit.M);
    ImportSummary found =
        imported.read(
            "csv", "time,id,x,y,width\n0,1,2,3,0\n0,2,2,3,1.8\n0,3,1,1,1e10\n0,4,0,0,-1\n");
    assertEquals(1, found.targetsWithSize());
    assertTrue(imported.tracks().contains("target 2 width 1.8 height 1.8;"), imported.tracks());
  }

  @ParameterizedTest
  @CsvSource({"obsmat, 1 1 1 1 1 1 1 1", "ethucy, 1 1 1 1", "mot, '1,1,1,1,1,1'"})
  void requiresRateForFrames(String format, String row) {
    assertRejected(new Imported(folder).unit(Unit.M), format, row, ": expected rate=R, the frames");
  }

  @Test
  void rejectsUnitsThatTheFormatDoesNotHave() {
    assertRejected(
        new Imported(folder).unit(Unit.CM),
        "fcd",
        "<fcd-export/>",
        ": unit is cm, expected m or none, because the format has no other");
  }

  private static void assertRejected(
      Imported imported, String format, String content, String message) {
    InputException error = assertThrows(InputException.class, () -> imported.read(format, content));
    assertTrue(error.getMessage().contains(message), error::getMessage);
  }
}
