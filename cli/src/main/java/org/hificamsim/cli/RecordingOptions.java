package org.hificamsim.cli;

import static picocli.CommandLine.Help.Visibility.NEVER;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Ranges;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.scenario.spec.Extent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.tracks.ImportSummary;
import org.hificamsim.tracks.TrackSettings;
import org.hificamsim.tracks.format.Recording;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.Homography;
import org.hificamsim.tracks.ground.LocalProjection;
import picocli.CommandLine.Option;

/** The options about a recording. */
final class RecordingOptions {
  private static final double MAX_VALUE = 1e9;

  @Option(names = "--rate", paramLabel = "R")
  private Double rate;

  @Option(names = "--unit", paramLabel = "U")
  private String unit;

  @Option(names = "--homography", paramLabel = "FILE")
  private Path homography;

  @Option(names = "--columns", split = ",", paramLabel = "KEY=NAME", showDefaultValue = NEVER)
  private Map<String, String> columns = new TreeMap<>();

  @Option(names = "--origin", paramLabel = "LAT,LON")
  private String origin;

  @Option(names = "--gap", paramLabel = "S")
  private Double gap;

  @Option(names = "--from", paramLabel = "S")
  private Double from;

  @Option(names = "--to", paramLabel = "S")
  private Double to;

  @Option(names = "--size", paramLabel = "M[xM]")
  private String size;

  /** Returns the recording in a file, as the options describe it. */
  Recording recording(Path file) {
    return new Recording(file, positive("--rate", rate), unit(), columns);
  }

  private Optional<Unit> unit() {
    return unit == null ? Optional.empty() : Optional.of(unit("--unit", unit));
  }

  static Unit unit(String option, String text) {
    return Spelling.require(Unit.class, option, text);
  }

  /** The settings by which samples become tracks. */
  TrackSettings settings() {
    double start = from == null ? 0 : Ranges.within("--from", from, 0, MAX_VALUE);
    double end = to == null ? MAX_VALUE : Ranges.within("--to", to, start, MAX_VALUE);
    return new TrackSettings(positive("--gap", gap), start, end, edge(), extent());
  }

  /** The value of an option that has to be above 0; empty if it is not given. */
  static OptionalDouble positive(String option, Double value) {
    if (value == null) {
      return OptionalDouble.empty();
    }
    if (!(value > 0 && value <= MAX_VALUE)) {
      throw new InputException(option + " is " + value + ", expected a number above 0");
    }
    return OptionalDouble.of(value);
  }

  private double edge() {
    return size == null || size.contains("x") ? TargetSpec.DEFAULT_SIZE : metres(size);
  }

  private Optional<Extent> extent() {
    if (size == null || !size.contains("x")) {
      return Optional.empty();
    }
    int cross = size.indexOf('x');
    return Optional.of(
        new Extent(metres(size.substring(0, cross)), metres(size.substring(cross + 1))));
  }

  private double metres(String text) {
    try {
      double metres = Double.parseDouble(text);
      if (metres > 0 && metres <= MAX_VALUE) {
        return metres;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw InputException.of("--size is '%s', expected metres above 0, as 0.5 or 0.5x1.75", size);
  }

  /** Describes the sizes of the targets. */
  String sizeLine(ImportSummary summary) {
    String others = size == null ? TargetSpec.DEFAULT_SIZE + " m (--size)" : size + " m";
    return summary.targetsWithSize() == summary.targets()
        ? "sizes: from the file"
        : summary.targetsWithSize() == 0
            ? "size: " + others
            : "sizes: of "
                + summary.targetsWithSize()
                + " targets from the file, of the others "
                + others;
  }

  Optional<Homography> homography() {
    return Optional.ofNullable(homography).map(Homography::read);
  }

  LocalProjection projection() {
    if (origin == null) {
      return new LocalProjection();
    }
    double[] degrees = Numbers.pair("--origin", origin, "latitude and longitude, as 48.2,16.37");
    Ranges.within("--origin", degrees[0], -90, 90);
    Ranges.within("--origin", degrees[1], -180, 180);
    return new LocalProjection(degrees[1], degrees[0]);
  }
}
