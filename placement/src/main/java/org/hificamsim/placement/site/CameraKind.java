package org.hificamsim.placement.site;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;

/**
 * A kind of camera that can be bought.
 *
 * @param optics the lens, which may pan and zoom
 * @param price in the currency of the catalogue, above 0
 */
public record CameraKind(String name, OpticsSpec optics, double price) {
  /** The name of the built-in catalogue: generic lenses, with approximate prices of 2025. */
  public static final String GENERIC = "generic";

  /** The name of the catalogue of all kinds that the scenario has, each at the price of 1. */
  public static final String SITE = "site";

  private static final List<String> COLUMNS =
      List.of("name", "pixels", "hfov_min", "hfov_max", "pan", "price");

  /** The number of zoom levels of a lens that zooms. */
  private static final int ZOOM_LEVELS = 4;

  private static final double PAN_STEP_DEGREES = 15;
  private static final double ALL_ROUND_DEGREES = 180;

  /**
   * Returns the catalogue with a name, or reads it from a file.
   *
   * @throws InputException if the file is missing or wrong, with line and column
   */
  public static List<CameraKind> catalogue(String name, Scenario site) throws IOException {
    if (name.equals(SITE)) {
      return of(site.name(), site.everyCamera());
    }
    return name.equals(GENERIC) ? generic() : read(Path.of(name));
  }

  /** Returns the kinds of some cameras, each at the price of 1. */
  static List<CameraKind> of(String site, Stream<CameraSpec> cameras) {
    List<CameraKind> kinds =
        cameras
            .flatMap(camera -> camera.optics().stream())
            .filter(optics -> optics.law().hasAngles())
            .distinct()
            .map(optics -> new CameraKind(optics.name(), optics, 1))
            .toList();
    if (kinds.isEmpty()) {
      throw InputException.of(
          "scenario '%s' has no camera with a lens, expected one, or generic ones or a file", site);
    }
    return kinds;
  }

  private static List<CameraKind> generic() throws IOException {
    Path copy = Files.createTempFile("cameras", ".csv");
    try (InputStream in = CameraKind.class.getResourceAsStream("cameras.csv")) {
      Files.write(copy, in.readAllBytes());
      return read(copy);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } finally {
      Files.delete(copy);
    }
  }

  private static List<CameraKind> read(Path file) {
    List<CameraKind> kinds = new ArrayList<>();
    for (CsvRow row : CsvReader.open(file, "a catalogue of cameras").readAll(COLUMNS).rows()) {
      String name = row.text("name");
      if (name.isBlank() || kinds.stream().anyMatch(kind -> kind.name.equals(name))) {
        throw row.invalid("name", "a name that no other camera has");
      }
      kinds.add(new CameraKind(name, optics(name, row), number(row, "price", 1e-9, 1e9)));
    }
    if (kinds.isEmpty()) {
      throw new InputException(file + ": no camera, expected one at least");
    }
    return kinds;
  }

  private static OpticsSpec optics(String name, CsvRow row) {
    double narrowest = number(row, "hfov_min", 0.1, 179);
    double widest = number(row, "hfov_max", narrowest, 179);
    double pan = number(row, "pan", 0, 180);
    int pixels = (int) number(row, "pixels", 1, 100_000);
    int levels = widest > narrowest ? ZOOM_LEVELS : 1;
    Stream<Double> angles =
        Stream.iterate(0, level -> level < levels, level -> level + 1)
            .map(level -> level / Math.max(1.0, levels - 1))
            .map(part -> narrowest * Math.pow(widest / narrowest, part))
            .map(angle -> Math.rint(10 * angle) / 10);
    boolean allRound = pan == ALL_ROUND_DEGREES;
    double lastPan = allRound ? pan - PAN_STEP_DEGREES : pan; // -180 and 180 are the same
    Stream<Double> pans =
        Stream.iterate(-pan, angle -> angle <= lastPan, angle -> angle + PAN_STEP_DEGREES);
    OpticsSpec lens =
        new OpticsSpec(name)
            .with(OpticsSpec.PIXELS, pixels)
            .with(OpticsSpec.ANGLES_OF_VIEW, angles.toList())
            .with(OpticsSpec.PANS, pans.toList());
    return pan == 0 ? lens : lens.with(OpticsSpec.PAN_SPEED, 100).with(OpticsSpec.ZOOM_TIME, 3);
  }

  private static double number(CsvRow row, String column, double least, double greatest) {
    String expected = "a number from %s to %s".formatted(least, greatest);
    return row.number(column, least, greatest, expected);
  }
}
