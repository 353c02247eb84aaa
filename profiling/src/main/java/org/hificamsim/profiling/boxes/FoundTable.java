package org.hificamsim.profiling.boxes;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.Texts;
import org.hificamsim.profiling.boxes.BoxBins.Bin;
import org.hificamsim.profiling.dataset.TableLayout;

/** The share found of each recording, and of all, by height and by hidden share. */
public final class FoundTable {
  private static final String ALL = "all";
  private static final int LABEL_WIDTH = 28;

  private final MeasuredBoxes measured;
  private final List<Row> rows = new ArrayList<>();

  /** A range of boxes of one recording, or of all. */
  private record Row(String recording, String range, FoundShare share) {}

  /** Creates the table. */
  public FoundTable(MeasuredBoxes measured) {
    this.measured = measured;
    Bin notHidden = BoxBins.hidden().get(0);
    for (Bin height : BoxBins.heights(measured.boxes())) {
      add(height, notHidden, notHidden.label() + ", " + height.label());
    }
    Bin anyHeight = new Bin(0, Double.MAX_VALUE, "");
    BoxBins.hidden().forEach(hidden -> add(anyHeight, hidden, hidden.label()));
  }

  private void add(Bin height, Bin hidden, String range) {
    List<PersonBox> within =
        measured.boxes().stream()
            .filter(box -> height.contains(box.height()) && hidden.contains(box.hidden()))
            .toList();
    for (String recording : columns()) {
      rows.add(
          new Row(
              recording,
              range,
              FoundShare.of(
                  within.stream()
                      .filter(box -> recording.equals(ALL) || box.recording().equals(recording))
                      .toList())));
    }
  }

  private List<String> columns() {
    Stream<String> names = measured.recordings().stream().map(RecordingCounts::recording);
    return measured.recordings().size() > 1
        ? Stream.concat(names, Stream.of(ALL)).toList()
        : names.toList();
  }

  /** Returns the table as CSV; ranges without a box are left out. */
  String csv() {
    return new TableLayout<Row>()
        .with("recording", row -> TableLayout.quoted(row.recording()))
        .with("range", row -> TableLayout.quoted(row.range()))
        .with("boxes", row -> row.share().boxes())
        .with("people", row -> row.share().people())
        .with("found", row -> rounded(row.share().found()))
        .with("found_low", row -> rounded(row.share().low()))
        .with("found_high", row -> rounded(row.share().high()))
        .csv(rows.stream().filter(row -> row.share().boxes() > 0).toList());
  }

  private static String rounded(double value) {
    return Double.isNaN(value) ? "" : Texts.format("%.4f", value);
  }

  /** Returns the table in lines: a row for each range, a column for each recording. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    lines.add(line("found of", columns()));
    int width = columns().size();
    for (int first = 0; first < rows.size(); first += width) {
      List<Row> rangeRows = rows.subList(first, first + width);
      lines.add(line(rangeRows.get(0).range(), rangeRows.stream().map(FoundTable::cell).toList()));
    }
    return lines;
  }

  private String line(String label, List<String> cells) {
    StringBuilder line = new StringBuilder(Texts.format("%-" + LABEL_WIDTH + "s", label));
    for (int i = 0; i < cells.size(); i++) {
      int width = Math.max(17, columns().get(i).length());
      line.append(Texts.format("  %-" + width + "s", cells.get(i)));
    }
    return line.toString().stripTrailing();
  }

  private static String cell(Row row) {
    FoundShare share = row.share();
    return share.boxes() == 0
        ? "-"
        : Double.isNaN(share.low())
            ? Texts.format("%.2f", share.found())
            : Texts.format("%.2f [%.2f, %.2f]", share.found(), share.low(), share.high());
  }
}
