package org.hificamsim.profiling;

import java.nio.file.Path;
import java.util.List;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.DatasetReader;
import org.hificamsim.profiling.lab.LabSettings;
import org.hificamsim.profiling.lab.Laboratory;

/** A laboratory of a few dozen small photos. */
public final class SmallLab {
  private SmallLab() {}

  /** Renders it into a folder. */
  public static Dataset render(Path folder) {
    LabSettings settings =
        LabSettings.thesis(1)
            .withScale(0.08)
            .withGrid(List.of(0.010, 0.024, 0.085), List.of(1.0, 2.0, 4.0, 8.0), 4);
    new Laboratory(settings).render(folder, 2, () -> {});
    return DatasetReader.read(folder).dataset().orElseThrow();
  }
}
