package org.hificamsim.cli;

import java.util.Optional;
import java.util.function.Function;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.placement.site.CoverageReading;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.Sampling;
import org.hificamsim.placement.site.Visits;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.cells.FieldCells;
import picocli.CommandLine.Option;

/** The options of {@code place} for the points to be covered, and for when a camera covers one. */
final class DemandOptions {
  @Option(names = "--reading", paramLabel = "fixed|any")
  private String reading;

  @Option(names = "--redundancy", paramLabel = "K")
  private Optional<Integer> redundancy;

  @Option(names = "--demand", paramLabel = "zones|tracks")
  private String demand;

  @Option(names = "--cells", paramLabel = "N")
  private Optional<Integer> cells;

  /** The source of the weights of a site's cells. */
  private enum DemandSource {
    ZONES,
    TRACKS
  }

  /** The reading of the zones' demands, which says when a camera covers a point. */
  CoverageReading reading() {
    return Spelling.require(CoverageReading.class, "--reading", reading);
  }

  /**
   * Returns the demand of a site.
   *
   * @param usual the detection of zones that name none
   */
  Demand demand(Scenario site, Detection usual, Catalogue catalogue) {
    redundancy.ifPresent(k -> Numbers.inRange("--redundancy", k, 1, 100));
    boolean byTracks =
        Spelling.require(DemandSource.class, "--demand", demand) == DemandSource.TRACKS;
    FieldCells finest = sampling().finest(site);
    return Demand.of(
        site,
        byTracks ? Sampling.equal(Math.max(finest.columns(), finest.rows())) : sampling(),
        redundancy,
        new Demand.Detections(usual, detections(catalogue)),
        byTracks ? Optional.of(Visits.of(site, finest, catalogue)) : Optional.empty());
  }

  private Sampling sampling() {
    return cells
        .map(number -> Sampling.equal(Numbers.inRange("--cells", number, 1, FieldCells.MAX)))
        .orElse(Sampling.BY_ZONE);
  }

  /** Finds the detections that zones name. */
  static Function<String, Detection> detections(Catalogue catalogue) {
    return name -> DetectionSpec.parse(name, catalogue::detection).detection(Settings.NONE);
  }
}
