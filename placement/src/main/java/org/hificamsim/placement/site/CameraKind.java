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
 * @param optics a lens, which may turn
 * @param price in whatever the catalogue counts in, above 0
 */
public record CameraKind(String name, OpticsSpec optics, double price) {
  /** The catalogue that comes with the program: generic lenses, prices of the order of 2025. */
  public static final String GENERIC = "generic";

  /** The kinds of cameras that the scenario itself has, each at the price of 1. */
  public static final String OF_SITE = "site";

  private static final List<String> COLUMNS =
      List.of("name", "pixels", "hfov_min", "hfov_max", "pan", "price");
  private static final int LEVELS = 4; // of a lens that zooms
  private static final double PAN_STEP = 15; // degrees

  /**
   * A catalogue by its name, or a file of them.
   *
   * @throws InputException when it is missing or wrong, with its place
   */
  public static List<CameraKind> catalogue(String name, Scenario site) throws IOException {
    if (name.equals(OF_SITE)) {
      return of(site.name(), site.everyCamera());
    }
    return name.equals(GENERIC) ? generic() : read(Path.of(name));
  }

  /** The kinds of some cameras, each at the price of 1. */
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
    for (CsvRow row : CsvReader.open(file, "a catalogue of cameras").all(COLUMNS).rows()) {
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
    int levels = widest > narrowest ? LEVELS : 1;
    Stream<Double> angles =
        Stream.iterate(0, i -> i < levels, i -> i + 1)
            .map(i -> narrowest * Math.pow(widest / narrowest, i / Math.max(1.0, levels - 1)))
            .map(angle -> Math.rint(10 * angle) / 10);
    double most = pan == 180 ? pan - PAN_STEP : pan; // all round, each heading once
    Stream<Double> pans = Stream.iterate(-pan, angle -> angle <= most, angle -> angle + PAN_STEP);
    OpticsSpec lens =
        new OpticsSpec(name)
            .with(OpticsSpec.PIXELS, pixels)
            .with(OpticsSpec.ANGLES_OF_VIEW, angles.toList())
            .with(OpticsSpec.PANS, pans.toList());
    return pan == 0 ? lens : lens.with(OpticsSpec.PAN_SPEED, 100).with(OpticsSpec.ZOOM_TIME, 3);
  }

  private static double number(CsvRow row, String column, double least, double most) {
    return row.number(column, least, most, "a number from %s to %s".formatted(least, most));
  }
}
