package org.hificamsim.placement.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.scenario.Scenario;

/**
 * A list of the cameras that can be bought.
 *
 * @param currency the currency of their prices
 */
public record PriceList(List<CameraKind> kinds, String currency) {
  /** The name of the built-in list, which has generic lenses at approximate prices of 2025. */
  public static final String GENERIC = "generic";

  /** The name of the list that has all kinds of cameras of the scenario, each at the price of 1. */
  public static final String SITE = "site";

  /** The currency of lists that name none. */
  public static final String USUAL_CURRENCY = "EUR";

  /**
   * Returns the list with a name, or reads it from a file.
   *
   * @throws InputException if the file is missing or wrong, with line and column
   */
  public static PriceList named(String name, Scenario site) {
    return switch (name) {
      case SITE -> new PriceList(CameraKind.of(site.name(), site.everyCamera()), USUAL_CURRENCY);
      case GENERIC -> generic();
      default -> DataSheets.read(Path.of(name), site.hasHeights());
    };
  }

  /** The built-in list. */
  static PriceList generic() {
    return Generic.LIST;
  }

  /** Holds the built-in list, so that it is read when it is first needed. */
  private static final class Generic {
    private static final PriceList LIST = Io.get(Generic::read);

    private static PriceList read() throws IOException {
      Path copy = Files.createTempFile("cameras", ".csv");
      try {
        Files.write(copy, Io.resource(PriceList.class, "cameras.csv"));
        return DataSheets.read(copy, false);
      } finally {
        Files.delete(copy);
      }
    }
  }

  /**
   * Returns the kind with a name.
   *
   * @throws InputException if there is none
   */
  CameraKind kind(String name) {
    return kinds.stream()
        .filter(known -> known.name().equals(name))
        .findFirst()
        .orElseThrow(() -> InputException.of("kind is '%s', expected one of %s", name, names()));
  }

  /** The names of all kinds. */
  List<String> names() {
    return kinds.stream().map(CameraKind::name).toList();
  }
}
