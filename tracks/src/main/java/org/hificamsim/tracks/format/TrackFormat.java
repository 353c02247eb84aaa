package org.hificamsim.tracks.format;

import org.hificamsim.core.registry.Registry;

/**
 * A format of recorded tracks. An implementation reads a file once from start to end, and stores
 * nothing. Samples of one target are in the order of time; targets may alternate.
 */
public interface TrackFormat {
  /**
   * Reads a file.
   *
   * @param samples receives the unit, then each sample
   * @return the unit of time
   * @throws org.hificamsim.core.InputException with the place, if the file is wrong
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
