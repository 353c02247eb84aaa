package org.hificamsim.tracks;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests formats of drones, splines and simulators with small files. */
class MoreFormatsTest {
  private static final String ONE_TO_ONE = "1 0 0\n0 1 0\n0 0 1\n";
  private static final String VSP =
      """
      2 - the number of splines
      3 - Num of control points
      0.000000 -10.000000 0 17.97 - (2D point, m_id)
      10.000000 -10.000000 10 17.97 - (2D point, m_id)
      40 -10 40 0 - (2D point, m_id)
      1 - Num of control points
      5 6 3 0
      """;
  private static final String STEPS =
      """
      #IDXCOL=2,DATACOL=5,SEP=' '
      pedestrianId simTime endTime-PID1 startX-PID1 startY-PID1 endX-PID1 endY-PID1 targetId-PID2
      1 0.0 0.5 0.0 1.0 1.0 1.0 4
      2 0.0 0.4 5.0 5.0 5.0 4.0 3
      1 0.5 1.0 1.0 1.0 2.0 1.0 4
      2 0.9 1.3 5.0 4.0 5.0 3.0 3
      """;

  @TempDir Path folder;

  private Imported pixels() {
    return new Imported(folder).rate(10).homography(ONE_TO_ONE);
  }

  @Test
  void readsMiddlesOfDroneBoxes() {
    Imported imported = pixels();
    ImportSummary found =
        imported.read(
            "auto",
            """
            0 700 300 740 400 10 0 0 0 "Cart"
            0 702 300 742 400 11 0 0 1 "Cart"
            0 704 300 744 400 12 1 0 1 "Cart"
            7 100 100 110 120 10 0 1 0 "Golf Cart"
            """);
    assertEquals(
        "target 0 size 0.66;0 720 350;722 350;target 7 size 0.66;0 105 110;", imported.tracks());
    assertTrue(found.lines().toString().contains("left out: 1 entry that the file marks as not"));
  }

  @Test
  void samplesStraightSplinesEvenly() {
    Imported imported = pixels();
    imported.read("auto", VSP);
    assertEquals(
        "target 1 size 0.66;0 0 -10;10 -10;20 -10;30 -10;40 -10;target 2 size 0.66;0.3 5 6;",
        imported.tracks());
  }

  /** A quarter of a turn in 20 frames: the curve bends before and after the control point. */
  @Test
  void bendsSplinesBetweenControlPoints() {
    Imported imported = pixels();
    imported.read("vsp", "1\n3\n0 0 0 0\n10 0 20 0\n10 10 40 0\n");
    assertEquals(
        "target 1 size 0.66;0 0 0;5.625 -0.625;10 0;10.625 4.375;10 10;", imported.tracks());
  }

  @Test
  void rejectsSplinesThatEndEarly() {
    assertRejected("vsp", VSP.substring(0, 100), "the file ends, expected 3 control points");
    assertRejected(
        "vsp", "2\n1\n1 2 3 4\nx\n", ":4:1: number of control points is 'x', expected a whole");
    assertRejected(
        "vsp", "1\n2\n0 0 9 0\n1 1 8 0\n", ":4:1: the frame goes from 9.0 to 8.0, expected");
    assertRejected("vsp", "1\n2\n0 0 9 0\n1 1 1e9 0\n", ":4:1: the frame goes from 9.0 to 1.0E9");
  }

  private void assertRejected(String format, String content, String message) {
    Imported imported = pixels();
    InputException error = assertThrows(InputException.class, () -> imported.read(format, content));
    assertTrue(error.getMessage().contains(message), error::getMessage);
  }

  @Test
  void readsFootStepsOfVadere() {
    Imported imported = new Imported(folder);
    imported.read("auto", STEPS);
    assertEquals(
        "target 1 size 0.66;0 0 1;1 1;2 1;target 2 size 0.66;0 5 5;0.4 5 4;5 4;1.3 5 3;",
        imported.tracks());
  }

  @Test
  void countsTimeStepsOfOldVadere() {
    Imported imported = new Imported(folder).rate(2.5);
    imported.read("auto", "timeStep pedestrianId x-PID1 y-PID1\n1 3 0.5 1\n2 3 1.0 1\n3 3 NaN 1\n");
    assertEquals("target 3 size 0.66;0 0.5 1;1 1;", imported.tracks());
  }
}
