package org.hificamsim.reproduction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.reproduction.Table81.Cell;
import org.hificamsim.runs.Estimate;

/**
 * The judged cells of Table 8.1 and statements of the text.
 *
 * @param distances of the cells from the published ones, by reading
 * @param adapting what the optimum gains over a fixed zoom, which comes before all else
 */
public record Judgement(
    List<Table81.Cell> cells,
    List<Distance> distances,
    List<Judged> statements,
    List<Adapting> adapting) {
  /** The cells, then the statements. */
  Stream<Judged> all() {
    return Stream.concat(cells.stream().map(Table81.Cell::judged), statements.stream());
  }

  /** How many cells and statements have a verdict. */
  public String score(Verdict verdict) {
    return score(one -> true, verdict);
  }

  /** How many cells and statements of a role there are, and how many of them are reproduced. */
  public String score(FitRole role) {
    return score(one -> one.role() == role, Verdict.REPRODUCED) + " reproduced";
  }

  private String score(Predicate<Judged> which, Verdict verdict) {
    return share("cell", which, verdict) + ", " + share("statement", which, verdict);
  }

  private String share(String kind, Predicate<Judged> which, Verdict verdict) {
    List<Verdict> verdicts =
        all().filter(one -> one.kind().equals(kind)).filter(which).map(Judged::verdict).toList();
    return "%s of %s %ss"
        .formatted(Collections.frequency(verdicts, verdict), verdicts.size(), kind);
  }

  /**
   * A cell of Table 8.1 or a statement of the text, compared with what we find: a row of {@code
   * verdicts.csv}.
   *
   * @param kind {@code cell} or {@code statement}
   * @param source section, table or figure of the thesis
   * @param text what it says
   * @param published a cell's; NaN for a statement
   * @param value a cell's proportion; a statement's weakest margin
   * @param checks how many comparisons decide it
   * @param held how many of them hold
   * @param reason for the verdict, in one line
   * @param role whether the defaults were chosen for it
   */
  public record Judged(
      String kind,
      String id,
      String source,
      String text,
      double published,
      Estimate value,
      int checks,
      int held,
      Verdict verdict,
      String reason,
      FitRole role) {}

  /**
   * How far the nine cells of a detection model are from the published ones, under our defaults or
   * with one thing read otherwise.
   *
   * @param reading empty for our defaults
   * @param hifi whether these are the cells of the hi-fi model, else CamSim's
   * @param mean of the distances
   * @param within how many cells are at most 0.05 away
   */
  public record Distance(
      Optional<Reading> reading, boolean hifi, double mean, long within, int steps, int seeds) {
    /** Our defaults first, then each other reading: the hi-fi column, then CamSim's. */
    static List<Distance> of(List<Cell> cells, int steps, int seeds) {
      List<Distance> all = new ArrayList<>();
      List<Optional<Reading>> readings = new ArrayList<>(List.of(Optional.empty()));
      Arrays.stream(Reading.values()).map(Optional::of).forEach(readings::add);
      for (Optional<Reading> reading : readings) {
        for (boolean hifi : new boolean[] {true, false}) {
          double[] column =
              cells.stream()
                  .filter(cell -> cell.published().hifi() == hifi)
                  .mapToDouble(cell -> Math.abs(cell.of(reading) - cell.published().proportion()))
                  .toArray();
          long within = Arrays.stream(column).filter(Verdict::isNear).count();
          all.add(new Distance(reading, hifi, StatUtils.mean(column), within, steps, seeds));
        }
      }
      return all;
    }

    /** The name in files. */
    public String label() {
      return reading.map(Reading::label).orElse("default");
    }
  }

  /** Whether the defaults were chosen for something, or have to stand up to it. */
  public enum FitRole {
    /** The hi-fi column of Table 8.1, and what it says by itself: agreeing shows consistency. */
    FITTED,
    /** Everything else, which no default was chosen for. */
    HELD_OUT;

    /** The name in files. */
    public String label() {
      return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }
}
