package org.hificamsim.tracks;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Place;
import org.hificamsim.tracks.format.Doubt;
import org.hificamsim.tracks.format.Unit;

/** The oddities of the files of a recording. */
final class ReadingNotes {
  private final LeftOut leftOut = new LeftOut();
  private final List<String> lines = new ArrayList<>();
  private final List<Doubt> doubts = new ArrayList<>();
  private Unit unit = Unit.M;
  private long duplicates;
  private String firstDuplicate = "";

  /** The rows that were left out. */
  LeftOut leftOut() {
    return leftOut;
  }

  void addDuplicate(Place place) {
    firstDuplicate = duplicates++ == 0 ? place.toString() : firstDuplicate;
  }

  /** Adds the oddities of another file. */
  void combine(ReadingNotes other) {
    leftOut.combine(other.leftOut);
    lines.addAll(other.lines);
    unit = other.unit;
    doubts.addAll(other.doubts);
    firstDuplicate = duplicates == 0 ? other.firstDuplicate : firstDuplicate;
    duplicates += other.duplicates;
  }

  /** Adds the signs that files are read in the wrong way. */
  void addTo(Plausibility signs) {
    leftOut.addTo(signs);
    doubts.forEach(doubt -> signs.fault(doubt.problem(), doubt.cure()));
  }

  /** Notes the unit of a file's positions. */
  void measuredIn(Unit fileUnit) {
    unit = fileUnit;
  }

  /** The unit of positions. */
  Unit unit() {
    return unit;
  }

  /** Adds a sign that a file is read in the wrong way. */
  void addDoubt(Doubt sign) {
    doubts.add(sign);
  }

  /** Adds a line about how the files were read. */
  void addLine(String line) {
    lines.add(line);
  }

  /** The lines on how the files were read. */
  List<String> lines() {
    return lines;
  }

  /** Describes samples that repeat the previous one; empty if there are none. */
  List<String> duplicateLines() {
    return duplicates == 0
        ? List.of()
        : List.of(
            duplicates + " samples are there twice and count once, the first at " + firstDuplicate);
  }
}
