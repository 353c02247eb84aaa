package org.hificamsim.profiling.boxes;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.profiling.boxes.ExpectedPeople.Sums;
import org.hificamsim.profiling.dataset.TableLayout;

/** Writes the chances that detections give to the people of a recording, by frame and person. */
public final class ExpectedFolder {
  /** The table of detections. */
  public static final String DETECTIONS = "expected.csv";

  /** The table of frames. */
  public static final String FRAMES = "frames.csv";

  /** The table of people. */
  public static final String PEOPLE = "people.csv";

  private ExpectedFolder() {}

  /** Adds the tables to the files of a folder, which the caller commits. */
  public static void write(OutputFolder folder, List<ExpectedPeople> expected) throws IOException {
    folder.write(
        DETECTIONS,
        new TableLayout<ExpectedPeople>()
            .with("detection", row -> TableLayout.quoted(row.detection()))
            .with("found", row -> rounded(row.reliability().all().detected()))
            .with("expected", row -> rounded(row.reliability().all().expected()))
            .with("error", row -> rounded(row.reliability().all().error()))
            .with("correlation", row -> rounded(row.correlation()))
            .with("log_loss", row -> rounded(row.reliability().logLoss()))
            .with("worst_fifth", row -> rounded(row.reliability().worstFifth()))
            .csv(expected));
    folder.write(FRAMES, table("frame", expected, ExpectedPeople::byFrame));
    folder.write(PEOPLE, table("person", expected, ExpectedPeople::byPerson));
  }

  /** A row for each key, with what was found and a column for what each detection expects. */
  private static <K> String table(
      String key, List<ExpectedPeople> expected, Function<ExpectedPeople, Map<K, Sums>> sums) {
    List<Map<K, Sums>> columns = expected.stream().map(sums).toList();
    TableLayout<K> layout =
        new TableLayout<K>()
            .with(key, row -> TableLayout.quoted(String.valueOf(row)))
            .with("boxes", row -> columns.get(0).get(row).boxes())
            .with("found", row -> columns.get(0).get(row).found());
    for (int i = 0; i < columns.size(); i++) {
      Map<K, Sums> column = columns.get(i);
      layout.with(
          TableLayout.quoted(expected.get(i).detection()),
          row -> rounded(column.get(row).expected()));
    }
    return layout.csv(List.copyOf(columns.get(0).keySet()));
  }

  private static String rounded(double value) {
    return Double.isNaN(value) ? "" : Texts.format("%.4f", value);
  }
}
