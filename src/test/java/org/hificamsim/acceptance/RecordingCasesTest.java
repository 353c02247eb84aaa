package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests {@code import} on recordings in forms that people publish, some of them irregular. */
class RecordingCasesTest {
  private static final Path CASES = Cli.ROOT.resolve("src/test/resources/cases");

  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "csv-blanks/annotations.txt --format csv --columns id=1,frame=6,x=2,y=3 --rate 30 --unit px"
            + " --homography mot-blanks/H.txt|4 samples of 2 targets in 0.03333 s",
        "csv-epoch-mm/atc.csv --format csv --columns time=1,id=2,x=3,y=4 --unit mm"
            + "|3 samples of 1 targets in 0.066 s; x from -1 to -0.92 m, y from 2 to 2 m",
        "csv-ind/00_tracks.csv --columns frame=frame,id=trackId,x=xCenter,y=yCenter,width=width"
            + " --rate 25 --unit m"
            + "|4 samples of 2 targets; sizes: of 1 targets from the file, of the others 0.66 m",
        "csv-units-row/occupants.csv --columns time=t --unit m"
            + "|3 samples of 1 targets in 1 s; left out: 1 entry without an id; csv:2:5: id is ''",
        "fcd-geo/fcd.xml --format fcd|3 samples of 1 targets in 2 s; x from 0 to 19.4 m",
        "geojson-multiline/tracks.geojson --format geojson"
            + "|5 samples of 1 targets in 80 s; 1 gaps longer than 30 s, up to 50 s",
        "geojson-single/feature.geojson --format geojson|3 samples of 1 targets in 20 s",
        "geojson-single/with-waypoint.geojson --format geojson"
            + "|3 samples of 1 targets in 20 s; left out: 1 entry of no track",
        "gpx-partial-times/track.gpx --format gpx|3 samples of 1 targets in 20 s; left out: 2"
            + " entries without a time; gpx:3:62: <trkpt>",
        "mot-blanks/tracks.txt --format mot --rate 25 --unit px --homography mot-blanks/H.txt"
            + "|2 samples of 1 targets in 0.04 s; x from 3.2 to 3.22 m, y from 3.8 to 3.8 m",
        "mot-visdrone/gt.txt --rate 25 --unit px --homography mot-visdrone/H.txt"
            + "|5 samples of 2 targets in 0.08 s",
        "sumo-csv/xml2csv.csv --format csv --unit m"
            + " --columns time=timestep_time,id=vehicle_id,x=vehicle_x,y=vehicle_y"
            + "|2 samples of 1 targets in 1 s; left out: 3 entries with neither id nor place",
        "sumo-csv/fcd.csv --format csv --unit m"
            + " --columns time=timestep_time,id=vehicle_id,x=vehicle_x,y=vehicle_y"
            + "|4 samples of 2 targets in 1 s",
        "trajnet-question/test.txt --format ethucy --rate 25"
            + "|5 samples of 2 targets in 0.8 s; left out: 2 entries whose place is unknown",
        "trajnet-question/test.txt --rate 25|format: ethucy; 5 samples of 2 targets in 0.8 s",
      })
  void readsPublishedRecordings(String command, String expected) {
    Cli imported = imported(command);
    assertEquals(0, imported.exit(), imported.err());
    for (String words : expected.split("; ")) {
      assertTrue(imported.out().contains(words), words + " in " + imported.out());
    }
  }

  @Test
  void rejectsFlagsReadAsPositions() {
    imported("mot-visdrone/gt.txt --format mot --rate 25 --unit m")
        .assertRejected(
            "a class and flags, and no places in metres, expected --unit px and --homography FILE,"
                + " or --force-reading",
            folder.resolve("out"));
    assertEquals(
        0, imported("mot-visdrone/gt.txt --format mot --rate 25 --unit m --force-reading").exit());
  }

  /** The speeds of SUMO reveal that positions are degrees even if the header is lost. */
  @Test
  void rejectsDegreesOfSumoReadAsMetres() throws IOException {
    String fcd = Files.readString(CASES.resolve("fcd-geo/fcd.xml"));
    Path bare = Files.writeString(folder.resolve("bare.xml"), fcd.replaceAll("(?s)<!--.*-->", ""));
    imported(bare + " --format fcd")
        .assertRejected(
            "by their speeds: positions are degrees, expected --unit deg", folder.resolve("out"));
    assertTrue(imported(bare + " --unit deg").out().contains("x from 0 to 19.4 m"));
    Path attribute =
        Files.writeString(
            folder.resolve("attribute.xml"),
            Files.readString(bare).replace("<fcd-export>", "<fcd-export geo=\"true\">"));
    assertTrue(imported(attribute.toString()).out().contains("x from 0 to 19.4 m"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "trajnet-question/test.txt --format mot --rate 25 --unit m|:1:1: columns are separated by"
            + " blanks, MOTChallenge has commas, expected a file in the format mot, or the format"
            + " ethucy",
        "mot-visdrone/gt.txt --format ethucy --rate 25"
            + "|:1:1: columns are separated by commas, ETH/UCY has blanks, expected",
        "fcd-geo/fcd.xml --format gpx|:1:1: the file begins with <fcd-export>, GPX has <gpx>,",
        "gpx-partial-times/track.gpx --format geojson"
            + "|:1:1: the file begins with <gpx>, GeoJSON has features, expected a file in the",
        "geojson-single/feature.geojson --format trajnet|:1:1: the file is JSON, TrajNet++ has",
        "csv-epoch-mm/atc.csv --unit m|:1:1: the file has 8 numbers between commas, which fits no"
            + " format, expected --format",
        "mot-blanks/tracks.txt|expected --rate R, the frames per second, which a file of this"
            + " format does not have (read as mot, because the file has 10 numbers between blanks)",
      })
  void rejectsFileOfOtherFormat(String command, String message) {
    imported(command).assertRejected(message, folder.resolve("out"));
  }

  private Cli imported(String command) {
    List<Object> words = new ArrayList<>(List.of("import", "--out", folder.resolve("out")));
    for (String word : command.split(" ")) {
      Path file = CASES.resolve(word);
      words.add(Files.isRegularFile(file) ? file : word);
    }
    return Cli.run(words.toArray());
  }
}
