package org.hificamsim.tracks.format;

import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.hificamsim.core.registry.Registry;

/**
 * A format that is read, as users know it. Its class declares it, next to the rule by which it is
 * recognised. The table of formats in the documentation has these texts.
 *
 * @param name as users choose it
 * @param look what a line or element looks like, in Markdown
 * @param time where times are from, in Markdown with names of settings
 * @param positions what positions are, in the same
 * @param maker makes a reader
 */
public record KnownFormat(
    String name, String look, String time, String positions, Supplier<TrackFormat> maker) {
  /** All formats, in the order of the documentation. */
  public static List<KnownFormat> all() {
    return Stream.of(
            RowFormat.OBSMAT,
            RowFormat.ETHUCY,
            TrajNetFormat.DECLARATION,
            MotFormat.DECLARATION,
            SddFormat.DECLARATION,
            VspFormat.DECLARATION,
            PeTrackFormat.DECLARATION,
            JuPedSimFormat.DECLARATION,
            VadereFormat.DECLARATION,
            FcdFormat.DECLARATION,
            GpxFormat.DECLARATION,
            GeoJsonFormat.DECLARATION,
            CsvFormat.DECLARATION)
        .toList();
  }

  /** All formats by name. */
  static Registry<KnownFormat> registry() {
    Registry<KnownFormat> registry = new Registry<>("format");
    all().forEach(format -> registry.register(format.name(), format.look(), () -> format));
    return registry;
  }

  @Override
  public String toString() {
    return name;
  }
}
