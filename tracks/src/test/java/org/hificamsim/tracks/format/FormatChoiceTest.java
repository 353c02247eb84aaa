package org.hificamsim.tracks.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that formats are recognised by the beginning of a file. */
class FormatChoiceTest {
  @TempDir Path folder;

  private Recording recording(String content, Map<String, String> columns) throws IOException {
    Path file = Files.writeString(folder.resolve("recording"), content.replace(';', '\n'));
    return new Recording(file, OptionalDouble.empty(), Optional.empty(), columns);
  }

  private String chosen(String content) throws IOException {
    return FormatChoice.of("auto", recording(content, Map.of())).known().name();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "obsmat|1.0e+00 1.0e+00 -2.8 0.0 18.9 0 0 -1.3;1.1e+01 1 -2.8 9 18.4 0 0 -1.3",
        "ethucy|780 1 8.46 3.59;790 1 9.57 3.79;800 1 10.6 3.9;780 2 1 9;790 2 1 8.4",
        "ethucy|0 1 0 0;0 2 9 9;10 1 0.4 0;10 2 9 8.6;20 1 0.9 0;20 2 9 8.1",
        "ethucy|10\t1.0\t2.5\t3;11\t1.0\t3.5\t4",
        "petrack|1 0 0 0;1 1 0.1 0;1 2 0.2 0;2 0 9 9;2 1 9 9.1;2 2 9 9.2",
        "petrack|1 0 1 2 1.7;1 1 1.1 2 1.7;2 0 9 9 1.6;2 1 9.1 9 1.6",
        "petrack|# framerate: 16;1 0 1 2",
        "petrack|#description: jpscore;#framerate: 16.00;#ID FR X Y Z A B ANGLE COLOR;1 0 3 3 0 1 1"
            + " 9 0",
        "mot|1,1,794.27,247.59,71.245,174.88,-1,-1,-1,-1",
        "mot|1,1,912,484,97,109,0,7,1",
        "mot|1 1 280.0 180.0 80.0 200.0 -1 -1 -1 -1 ",
        "sdd|0 700 300 740 400 0 0 0 0 \"Biker\"",
        "vsp|2 - the number of splines;3 - Num of control points;0 -1 0 1.5 - (2D point, m_id)",
        "vadere|pedestrianId simTime endTime-PID1 startX-PID1 startY-PID1 endX-PID1 endY-PID1",
        "trajnet|{\"scene\": {\"id\": 0, \"fps\": 2.5}}",
        "geojson|{\"type\":\"FeatureCollection\",\"features\":[]}",
        "geojson|{ \"geometry\" : null, \"type\":\"Feature\"}",
        "fcd|<?xml version='1.0'?>;<!-- <gpx/> -->;<fcd-export><timestep time='0'/></fcd-export>",
        "gpx|<gpx version='1.1'/>",
        "csv|time,id,x,y;0,1,2,3",
        "csv|frame x y;0 1 2",
      })
  void recognisesFormat(String format, String content) throws IOException {
    assertEquals(format, chosen(content));
  }

  @Test
  void recognisesTableByNamedColumns() throws IOException {
    Recording recording = recording("0,1,5,6,9,9,9", Map.of("time", "1", "x", "2", "y", "3"));
    assertEquals("csv", FormatChoice.of("auto", recording).known().name());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1 0 1 2|may be ethucy (has 4 numbers between blanks, the id in column 2) or petrack (has 4"
            + " numbers between blanks, the id in column 1), expected format, one of ethucy,"
            + " petrack",
        "0 0 1 1;0 1 2 1;1 0 2 1;1 1 3 1|expected format, one of ethucy, petrack",
        "1,2,3|the file has 3 numbers between commas, which fits no format, expected format, one"
            + " of",
        "t;0|the file has 1 fields between blanks, which fits no format, expected format, one of",
        "a,b,c;1,2,3|which say what the columns of a table are (a, b, c)",
        "<svg/>|the file begins with <svg>, which fits no format, expected format, one of obsmat",
        "|the file is empty, which fits no format",
      })
  void errorNamesFormatsIfNoneOrSeveralFit(String content, String message) throws IOException {
    Recording recording = recording(content == null ? "" : content, Map.of());
    InputException error =
        assertThrows(InputException.class, () -> FormatChoice.of("auto", recording));
    assertTrue(error.getMessage().contains(message), error::getMessage);
  }
}
