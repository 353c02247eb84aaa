package org.hificamsim.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Ranges;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.placement.site.MountPoints;
import picocli.CommandLine.Option;

/** The options of {@code place} for the positions of cameras, and for the cameras that stay. */
final class MountOptions {
  private static final String UNKNOWN = "%s: the site has no %s '%s', expected the name of one";

  /** The default number of candidate positions along the longer side of the field. */
  private static final double DEFAULT_POSITIONS = 40;

  /** The least distance of a camera from what it is mounted on, in metres. */
  private static final double MIN_CLEARANCE = 0.02;

  @Option(names = "--candidates", paramLabel = "every=M|FILE.csv")
  private Optional<String> candidates;

  @Option(names = "--clearance", paramLabel = "M")
  private double clearance;

  @Option(names = "--keep", paramLabel = "all|A,B")
  private Optional<String> keep;

  @Option(names = "--forbid", paramLabel = "ZONE,ZONE")
  private Optional<String> forbid;

  /**
   * Returns the positions of candidates.
   *
   * @param parts 1, or the factor by which positions are denser than the option says
   */
  List<Point> positions(Scenario site, int parts) {
    List<Zone> forbidden = named("--forbid", forbid, "zone", site.zones(), Zone::name);
    double longer = Math.max(site.field().width(), site.field().height());
    Ranges.within("--clearance", clearance, MIN_CLEARANCE, longer);
    String text = candidates.orElse("every=" + longer / DEFAULT_POSITIONS);
    if (!text.startsWith("every=")) {
      return MountPoints.read(Path.of(text), site, forbidden);
    }
    boolean ceiling = text.endsWith(",ceiling");
    String number = text.substring("every=".length()).replaceFirst(",ceiling$", "");
    try {
      double every =
          Ranges.within("--candidates every", Double.parseDouble(number), longer / 1000, longer);
      return MountPoints.of(
          site, new MountPoints.Rules(every / parts, clearance, ceiling, forbidden));
    } catch (NumberFormatException e) {
      throw new InputException(
          "--candidates is '" + text + "', expected every=M, every=M,ceiling or a table", e);
    }
  }

  /** The cameras of the site that stay. */
  List<CameraSpec> kept(Scenario site) {
    return keep.equals(Optional.of("all"))
        ? site.cameras()
        : named("--keep", keep, "camera", site.cameras(), CameraSpec::name);
  }

  /** Finds the parts of a site that an option names. */
  private static <T> List<T> named(
      String option, Optional<String> list, String kind, List<T> parts, Function<T, String> name) {
    return list.stream()
        .flatMap(text -> Stream.of(text.split(",")))
        .map(
            asked ->
                parts.stream()
                    .filter(part -> name.apply(part).equals(asked))
                    .findFirst()
                    .orElseThrow(() -> InputException.of(UNKNOWN, option, kind, asked)))
        .toList();
  }
}
