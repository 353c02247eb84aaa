package org.hificamsim.tracks.format;

import java.util.List;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.hificamsim.core.NamedSetting;
import org.hificamsim.core.registry.Registry;

/**
 * The description of a format for users. The format's class declares it, next to the rule by which
 * it is recognised. The table of formats in the documentation has these texts.
 *
 * @param name the name by which users choose it
 * @param look the form of a line or element, in Markdown
 * @param time the source of times, in Markdown with settings in braces
 * @param positions the unit of positions, in the same form
 * @param maker makes a reader
 */
public record KnownFormat(
    String name, String look, String time, String positions, Supplier<TrackFormat> maker) {
  /** A setting in a text, such as {@code {rate}} or {@code {unit=px}}. */
  private static final Pattern SETTING = Pattern.compile("\\{(\\w+)(?:=(\\w+))?\\}");

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

  /**
   * Returns the row of the documentation's table, with settings as users of a front end write them.
   */
  public String row(NamedSetting.Notation notation) {
    return SETTING
        .matcher("| `%s` | %s | %s | %s |".formatted(name, look, time, positions))
        .replaceAll(
            setting ->
                Matcher.quoteReplacement(
                    setting.group(2) == null
                        ? notation.name(setting.group(1))
                        : notation.assignment(setting.group(1), setting.group(2))));
  }
}
