package org.hificamsim.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.placement.site.BlindSpot;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.placement.site.EvaluatedPlan;
import org.hificamsim.placement.site.PlanCover;
import org.hificamsim.runs.output.TextTable;

/**
 * Prints the measures of an evaluated plan.
 *
 * @param file the scenario of the plan
 */
record PlanReview(Path file, EvaluatedPlan plan) {
  private static final String NONE = "-";

  /** The number of blind spots and of failures that are printed. */
  private static final int MAX_ROWS = 3;

  /** Prints the demand that the plan meets, its price, and the effect of failures. */
  void print(Screen screen) {
    PlanCover cover = plan.cover();
    screen.say("%s: %s", file, plan.facts().get(0));
    printZones(screen, cover);
    double[] shares = cover.sharesWithout();
    byShare(shares).stream()
        .limit(MAX_ROWS)
        .forEach(
            camera ->
                screen.say(
                    "  if %s fails: %.2f %% of the samples (%.2f %% with it)",
                    cover.cameras().get(camera).name(), 100 * shares[camera], 100 * cover.share()));
  }

  /** Prints the met share of each zone, and the largest blind spots. */
  static void printZones(Screen screen, PlanCover cover) {
    cover
        .demand()
        .zones()
        .forEach(zone -> screen.say("  zone %s: %s", zone.name(), met(cover, zone)));
    BlindSpot.Listing spots = BlindSpot.Listing.of(cover.blindSpots(), MAX_ROWS);
    spots.shown().forEach(spot -> screen.say("  not seen as asked: %s", spot));
    if (spots.others() > 0) {
      screen.say(
          "  and %s: %.1f m2", Texts.counted(spots.others(), "smaller spot"), spots.otherArea());
    }
  }

  private static String met(PlanCover cover, ZoneDemand zone) {
    return Texts.format(
        "%.2f %% by %s, k = %d", 100 * cover.claimedShare(zone), zone.detection().name(), zone.k());
  }

  /** Returns the numbers of cameras by the shares that are met without them, the smallest first. */
  private static List<Integer> byShare(double[] shares) {
    return IntStream.range(0, shares.length)
        .boxed()
        .sorted(Comparator.comparingDouble(camera -> shares[camera]))
        .toList();
  }

  private String worstFailure() {
    double[] shares = plan.cover().sharesWithout();
    return byShare(shares).stream()
        .findFirst()
        .map(
            camera ->
                Texts.format(
                    "%.2f %% of the samples, without %s",
                    100 * shares[camera], plan.cameras().get(camera).name()))
        .orElse(NONE);
  }

  /** Prints two plans side by side. */
  static void compare(Screen screen, PlanReview first, PlanReview second) {
    TextTable table = new TextTable(3, List.of("", first.file + "", second.file + ""));
    row(table, "cameras", first, second, review -> "" + review.plan.cameras().size());
    row(table, "price", first, second, review -> review.plan.priceText());
    row(
        table,
        "demand met",
        first,
        second,
        review -> Texts.format("%.2f %%", 100 * review.plan.cover().claimedShare()));
    for (String zone : zones(first, second)) {
      row(table, "zone " + zone, first, second, review -> review.met(zone));
    }
    row(table, "after the worst failure", first, second, PlanReview::worstFailure);
    if (!first.plan.demand().site().obstacles().equals(second.plan.demand().site().obstacles())) {
      row(table, "obstacles (not the same)", first, second, PlanReview::obstacles);
    }
    for (String camera : differingCameras(first, second)) {
      row(table, "camera " + camera, first, second, review -> review.camera(camera));
    }
    table.print(screen.out());
  }

  private static void row(
      TextTable table,
      String name,
      PlanReview first,
      PlanReview second,
      Function<PlanReview, String> cell) {
    table.row(List.of(name, cell.apply(first), cell.apply(second)));
  }

  private String obstacles() {
    return Integer.toString(plan.demand().site().obstacles().size());
  }

  private static Set<String> zones(PlanReview first, PlanReview second) {
    Set<String> names = new LinkedHashSet<>();
    List.of(first, second)
        .forEach(review -> review.plan.demand().zones().forEach(zone -> names.add(zone.name())));
    return names;
  }

  private String met(String zone) {
    return plan.demand().zones().stream()
        .filter(demanded -> demanded.name().equals(zone))
        .findFirst()
        .map(demanded -> met(plan.cover(), demanded))
        .orElse(NONE);
  }

  private static List<String> differingCameras(PlanReview first, PlanReview second) {
    Set<String> names = new LinkedHashSet<>();
    List.of(first, second)
        .forEach(review -> review.plan.cameras().forEach(camera -> names.add(camera.name())));
    List<String> differing = new ArrayList<>(names);
    differing.removeIf(name -> first.camera(name).equals(second.camera(name)));
    return differing;
  }

  private String camera(String name) {
    Optional<CameraSpec> camera =
        plan.cameras().stream().filter(spec -> spec.name().equals(name)).findFirst();
    return camera.map(PlanReview::describe).orElse(NONE);
  }

  private static String describe(CameraSpec camera) {
    return Texts.format(
        "(%.2f, %.2f)%s, heading %.1f%s%s, price %.2f",
        camera.x(),
        camera.y(),
        camera.z().isPresent() ? Texts.format(" at %.2f m", camera.z().getAsDouble()) : "",
        camera.heading(),
        camera.tilt() == 0 ? "" : Texts.format(", tilt %.1f", camera.tilt()),
        camera.optics().map(OpticsSpec::name).map(lens -> ", " + lens).orElse(""),
        camera.price());
  }
}
