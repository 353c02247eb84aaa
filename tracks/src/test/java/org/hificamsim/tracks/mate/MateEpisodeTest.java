package org.hificamsim.tracks.mate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Reference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MateEpisodeTest {
  private static final String HEADER =
      "step,c0_x,c0_y,c0_orientation,c0_viewing_angle,c0_sight_range,c1_x,c1_y,c1_orientation,"
          + "c1_viewing_angle,c1_sight_range,t0_x,t0_y,t1_x,t1_y\n";

  @TempDir Path folder;

  private MateEpisode replay(String poses, String obstacles) throws IOException {
    Files.writeString(folder.resolve("a.obstacles.csv"), "x,y,radius\n" + obstacles);
    return MateEpisode.replay(Files.writeString(folder.resolve("a.csv"), HEADER + poses));
  }

  /** The first camera looks east, the second north, from the origin and from (100, 0). */
  @Test
  void computesExpectedCoverage() throws IOException {
    String cameras = "0,0,0,0,60,50,100,0,450,60,50,";
    assertEquals(1, replay(cameras + "40,0,100,40\n", "").coverage(), 1e-12);
    assertEquals(0.5, replay(cameras + "60,0,100,40\n", "").coverage(), 1e-12, "out of range");
    assertEquals(
        0.5, replay(cameras + "20,20,100,40\n", "").coverage(), 1e-12, "outside the angle");
    assertEquals(0.55, replay(cameras + "40,0,100,40\n", "20,0,5\n").coverage(), 1e-12);
    MateEpisode twoSteps = replay(cameras + "40,0,100,40\n" + cameras + "60,0,100,60\n", "");
    assertEquals(0.5, twoSteps.coverage(), 1e-12, "the mean of two steps");
    assertEquals(2, twoSteps.steps());
  }

  @Test
  void reportsErrorsWithTheirPlace() {
    String cameras = "0,0,0,0,60,50,100,0,450,60,50,";
    InputException text =
        assertThrows(InputException.class, () -> replay(cameras + "4,x,1,4\n", ""));
    assertTrue(text.getMessage().contains("a.csv:2:"), text::getMessage);
    assertThrows(InputException.class, () -> replay("", ""), "no steps");
    assertThrows(InputException.class, () -> replay(cameras + "4,1,1,4\n", "1,2,-3\n"));
    Path none = folder.resolve("none.csv");
    assertThrows(InputException.class, () -> MateEpisode.replay(none));
  }

  /** The coverage that MATE itself counted, with its own random draws. */
  @ParameterizedTest
  @CsvSource({"0, 1416, 0.6671", "1, 1364, 0.5682", "2, 1088, 0.5924"})
  void reproducesCoverageOfMatesEpisodes(int episode, int steps, double coverage) {
    MateEpisode replayed = MateEpisode.replay(Reference.file("mate/episode" + episode + ".csv.gz"));
    assertEquals(steps, replayed.steps());
    assertEquals(coverage, replayed.coverage(), 0.01);
  }
}
