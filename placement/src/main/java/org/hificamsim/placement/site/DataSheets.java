package org.hificamsim.placement.site;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;

/**
 * Reads a catalogue of cameras: a table with the numbers of their data sheets, one row for each
 * product.
 *
 * @param withHeights whether the site has heights, so that the shape of pictures matters
 */
record DataSheets(Path file, boolean withHeights) {
  private static final List<String> REQUIRED = List.of("name", "resolution", "price");
  private static final List<String> OPTIONAL =
      List.of("hfov", "focal", "sensor", "pan", "currency");

  private static final Pattern RESOLUTION =
      Pattern.compile("(\\d{1,6})(?:\\s*[x×]\\s*(\\d{1,6}))?");
  private static final double USUAL_ASPECT = 16.0 / 9;
  private static final double PAN_STEP_DEGREES = 15;
  private static final double ALL_ROUND_DEGREES = 180;

  /**
   * Reads the table.
   *
   * @throws InputException with line and column if anything is missing, unknown or wrong
   */
  static PriceList read(Path file, boolean withHeights) {
    return new DataSheets(file, withHeights)
        .list(CsvReader.open(file, "a catalogue of cameras").readAll(REQUIRED));
  }

  private PriceList list(CsvRows table) {
    checkColumns(table.columns());
    List<CameraKind> kinds = new ArrayList<>();
    Optional<String> currency = Optional.empty();
    for (CsvRow row : table.rows()) {
      kinds.add(kind(row, kinds));
      Optional<String> rowCurrency = text(row, "currency");
      if (kinds.size() > 1 && !rowCurrency.equals(currency)) {
        throw row.invalid("currency", "that of all other rows, " + currency.orElse("none"));
      }
      currency = rowCurrency;
    }
    if (kinds.isEmpty()) {
      throw new Place(file.toString(), 1, 1)
          .error("the table has no camera, expected one at least");
    }
    return new PriceList(List.copyOf(kinds), currency.orElse(PriceList.USUAL_CURRENCY));
  }

  private void checkColumns(List<String> names) {
    List<String> known = Stream.concat(REQUIRED.stream(), OPTIONAL.stream()).toList();
    for (String name : names) {
      if (!known.contains(name)) {
        throw new Place(file.toString(), 1, 1 + names.indexOf(name))
            .error("column is '%s', expected any of %s", name, String.join(", ", known));
      }
    }
  }

  private CameraKind kind(CsvRow row, List<CameraKind> others) {
    String name = row.text("name");
    if (name.isBlank() || others.stream().anyMatch(other -> other.name().equals(name))) {
      throw row.invalid("name", "a name that no other camera has");
    }
    return new CameraKind(name, optics(name, row), number(row, "price", 1e-9, 1e9));
  }

  private OpticsSpec optics(String name, CsvRow row) {
    double pan = text(row, "pan").isPresent() ? number(row, "pan", 0, ALL_ROUND_DEGREES) : 0;
    boolean allRound = pan == ALL_ROUND_DEGREES;
    double lastPan = allRound ? pan - PAN_STEP_DEGREES : pan; // -180 and 180 are the same
    OpticsSpec lens =
        withResolution(new OpticsSpec(name), row)
            .with(OpticsSpec.ANGLES_OF_VIEW, angles(row))
            .with(
                OpticsSpec.PANS,
                Stream.iterate(-pan, angle -> angle <= lastPan, angle -> angle + PAN_STEP_DEGREES)
                    .toList());
    return pan == 0 ? lens : lens.with(OpticsSpec.PAN_SPEED, 100).with(OpticsSpec.ZOOM_TIME, 3);
  }

  private OpticsSpec withResolution(OpticsSpec lens, CsvRow row) {
    Matcher resolution = RESOLUTION.matcher(row.text("resolution"));
    if (!resolution.matches() || Integer.parseInt(resolution.group(1)) == 0) {
      throw row.invalid("resolution", "pixels across, as 1920, or 3840x2160");
    }
    int pixels = Integer.parseInt(resolution.group(1));
    OpticsSpec wide = lens.with(OpticsSpec.PIXELS, pixels);
    if (!withHeights || resolution.group(2) == null) {
      return wide;
    }
    double aspect = pixels / Double.parseDouble(resolution.group(2));
    return Math.abs(aspect / USUAL_ASPECT - 1) < 0.01 ? wide : wide.with(OpticsSpec.ASPECT, aspect);
  }

  /** Returns the angles of view of a lens, from narrow to wide, in degrees. */
  private static List<Double> angles(CsvRow row) {
    boolean byAngle = text(row, "hfov").isPresent();
    if (byAngle == text(row, "focal").isPresent()) {
      String column = row.has("hfov") ? "hfov" : row.has("focal") ? "focal" : "name";
      throw row.invalid(column, "one of hfov in degrees, and focal in mm with sensor");
    }
    if (byAngle) {
      return LensSteps.read(row, "hfov", "degrees", 0.1, 179).angles();
    }
    if (!row.has("sensor")) {
      throw row.invalid("focal", "a column sensor besides, its width in mm");
    }
    double sensor = number(row, "sensor", 0.1, 100);
    return LensSteps.read(row, "focal", "mm", 0.1, 10_000).onSensor(sensor).angles();
  }

  private static Optional<String> text(CsvRow row, String column) {
    return row.has(column) && !row.text(column).isBlank()
        ? Optional.of(row.text(column))
        : Optional.empty();
  }

  private static double number(CsvRow row, String column, double least, double greatest) {
    return row.number(column, least, greatest, "a number from %s to %s".formatted(least, greatest));
  }
}
