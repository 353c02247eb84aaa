package org.hificamsim.profiling.trial;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.profiling.dataset.CsvRows;
import org.hificamsim.profiling.measure.Measurement;

/** {@code simulation.csv}: every photo, as it was measured and as it is simulated. */
public final class TrialsFile {
  /** The file's name. */
  public static final String NAME = "simulation.csv";

  private static final String COLUMNS =
      "detector,model,image,object,size_m,distance_m,focal_length_m,confidence,threshold,"
          + "detected,simulated,chance\n";

  private TrialsFile() {}

  /** Writes it into a folder. */
  public static void write(Path folder, List<Trials> all) throws IOException {
    StringBuilder table = new StringBuilder(COLUMNS);
    for (Trials trials : all) {
      trials.photos().forEach(one -> table.append(row(trials, one)));
    }
    new OutputFile(folder.resolve(NAME)).write(table.toString());
  }

  private static String row(Trials trials, Trial one) {
    Measurement photo = one.photo();
    return "%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s,%s\n"
        .formatted(
            trials.model().detector(),
            trials.model().name(),
            CsvRows.quoted(photo.image()),
            CsvRows.quoted(photo.object()),
            photo.size(),
            photo.distance(),
            photo.focalLength(),
            photo.confidence(trials.model().detector()),
            trials.threshold(),
            one.measured() ? 1 : 0,
            one.simulated() ? 1 : 0,
            Double.isNaN(one.chance()) ? "" : one.chance());
  }
}
