package org.hificamsim.tracks.format;

import org.hificamsim.core.registry.Registry;

/**
 * A format of recorded tracks. An implementer reads a file once from front to back, keeping
 * nothing; samples of a target come in order of time, those of different targets in any order.
 */
public interface TrackFormat {
  /**
   * Reads a file.
   *
   * @param samples takes the unit, then each sample
   * @return how the format counts time
   * @throws org.hificamsim.core.InputException with the place, when something is wrong
   */
  Clock read(Recording recording, SampleSink samples);

  /** All formats by name. */
  static Registry<TrackFormat> registry() {
    return new Registry<TrackFormat>("format")
        .register(
            "obsmat",
            "ETH/UCY: frame id x z y vx vz vy",
            () -> new RowFormat("frame id x z y vx vz vy"))
        .register("ethucy", "ETH/UCY as text: frame id x y", () -> new RowFormat("frame id x y"))
        .register("trajnet", "TrajNet++: a JSON object a line", TrajNetFormat::new)
        .register("mot", "MOTChallenge: boxes, world positions", MotFormat::new)
        .register("petrack", "PeTrack and Juelich: id frame x y z", PeTrackFormat::new)
        .register("fcd", "SUMO's floating car data, XML", FcdFormat::new)
        .register("gpx", "GPX tracks, WGS84", GpxFormat::new)
        .register("geojson", "lines or points with times, WGS84", GeoJsonFormat::new)
        .register("csv", "any table, whose columns are named", CsvFormat::new);
  }
}
