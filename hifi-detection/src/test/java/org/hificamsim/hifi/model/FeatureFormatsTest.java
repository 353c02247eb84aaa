package org.hificamsim.hifi.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.feature.SvrRbfAbstraction;
import org.hificamsim.hifi.feature.SvrRbfAbstraction.Range;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class FeatureFormatsTest {
  private static final String MODEL =
      """
      {
        "schema": "hificamsim-model",
        "version": 1,
        "name": "mine",
        "f": {"type": "svr-rbf", "gamma": 0.5, "intercept": 1.5,
          "ranges": {"q": {"least": 0.1, "most": 0.66}, "d": {"least": 1, "most": 10},
            "z": {"least": 0.01, "most": 0.085}},
          "support": [[0.1, 1, 0.01, -0.25],
            [0.66, 10, 0.085, 1]]},
        "g": {"slope": 0.5, "intercept": 0.03}
      }
      """;

  @TempDir Path folder;

  @Test
  void writesEachSupportVectorOnItsOwnLine() throws IOException {
    HiFiDetection model =
        (HiFiDetection) ModelFiles.read(Files.writeString(folder.resolve("m.json"), MODEL));
    Range q = new Range(0.1, 0.66);
    double[][] support = {{0.1, 1, 0.01, -0.25}, {0.66, 10, 0.085, 1}};
    assertEquals(
        new SvrRbfAbstraction(0.5, 1.5, q, new Range(1, 10), new Range(0.01, 0.085), support),
        model.f());
    Path copy = folder.resolve("copy.json");
    ModelFiles.write(model, copy);
    assertEquals(model, ModelFiles.read(copy));
    assertTrue(
        Files.readAllLines(copy).stream().anyMatch(line -> line.contains("[0.1,1.0,0.01,-0.25]")),
        Files.readString(copy));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"gamma\": 0.5 | \"gamma\": 0 | 5:37: gamma is 0",
        "[0.66, 10, 0.085, 1] | [0.66, 10, 1] | 9:7: support holds a list of 3",
        "[0.66, 10, 0.085, 1] | 7 | 9:7: support holds 7, expected lists of 4 numbers",
        "0.085, 1] | 0.085, NaN] | 9:25: support holds NaN, expected numbers",
        "\"most\": 0.66 | \"most\": 0.1 | 6:44: most is 0.1, expected more than least, 0.1",
        "\"support\": [[ | \"supports\": [[ | 'support' is missing",
      })
  void reportsErrorWithLineAndColumn(String right, String wrong, String words) throws IOException {
    assertTrue(MODEL.contains(right));
    Path file = Files.writeString(folder.resolve("m.json"), MODEL.replace(right, wrong));
    String message = assertThrows(InputException.class, () -> ModelFiles.read(file)).getMessage();
    assertTrue(message.contains(words), message);
  }
}
