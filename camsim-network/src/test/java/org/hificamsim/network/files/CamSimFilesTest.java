package org.hificamsim.network.files;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimVisibilityDetection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.network.NetworkRun;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.runs.RunPlan;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CamSimFilesTest {
  @TempDir Path folder;

  @Test
  void failedRunDeletesOtherDraftsIfOneCannotBeDeleted() throws IOException {
    CamSimFiles files = files();
    Path draft = filesIn("steps").get(0);
    Files.delete(draft);
    Files.createDirectories(draft.resolve("not empty"));
    assertThrows(DirectoryNotEmptyException.class, files::close);
    assertEquals(List.of(), filesIn("coverage"));
  }

  /** The table of steps and the folder of the coverage, each in a folder of its own. */
  private CamSimFiles files() throws IOException {
    Path steps = Files.createDirectory(folder.resolve("steps"));
    CamSimFiles.Places places =
        new CamSimFiles.Places(
            folder.resolve("scenario.xml"),
            steps.resolve("o.csv"),
            Optional.empty(),
            Optional.of(folder.resolve("coverage")));
    Scenario scenario = new TestScenario().camera(0, 0).target(1, 0).scenario();
    Detection detection = Detection.of(new CamSimVisibilityDetection());
    RunPlan plan = new RunPlan(scenario, detection, "zoom-out", 1, 0, 1);
    return new CamSimFiles(
        places, plan, NetworkRun.of(plan, NetworkSettings.CAMSIM, Catalogue.load()));
  }

  private List<Path> filesIn(String name) throws IOException {
    try (Stream<Path> files = Files.list(folder.resolve(name))) {
      return files.toList();
    }
  }
}
