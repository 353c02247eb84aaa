package org.hificamsim.placement.output;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.hifi.density.DensityDetections;
import org.hificamsim.placement.site.BlindSpot;
import org.hificamsim.placement.site.CameraPlan;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.placement.site.PlanArea;

/** The tables of a plan's page and document, in words for people. */
final class PlanSections {
  private static final int MAX_SPOTS = 10;

  /** A table with its title. */
  record Section(String title, List<String> columns, List<List<String>> rows) {}

  private final CameraPlan plan;
  private final Demand demand;
  private final int[] counts;
  private final String currency;

  PlanSections(CameraPlan plan, String currency) {
    this.plan = plan;
    this.demand = plan.demand();
    this.counts = plan.cover().counts();
    this.currency = currency;
  }

  /** The tables, without those that have no row. */
  List<Section> sections() {
    return Stream.of(zoneTable(), orderTable(), cameraTable(), blindSpotTable())
        .filter(section -> !section.rows.isEmpty())
        .toList();
  }

  private Section orderTable() {
    List<PlanOrder.Product> products = PlanOrder.of(plan, currency);
    List<List<String>> rows = new ArrayList<>();
    for (PlanOrder.Product product : products) {
      String quantity = Integer.toString(product.quantity());
      rows.add(List.of(product.name(), quantity, money(product.price()), money(product.total())));
    }
    if (!rows.isEmpty()) {
      int quantity = products.stream().mapToInt(PlanOrder.Product::quantity).sum();
      rows.add(List.of("all", Integer.toString(quantity), "", money(plan.price())));
    }
    return new Section(
        "To order",
        List.of("camera", "quantity", "price, " + currency, "total, " + currency),
        rows);
  }

  private static String money(double amount) {
    return Texts.format("%.2f", amount);
  }

  private Section zoneTable() {
    List<List<String>> rows =
        demand.zones().stream()
            .map(
                zone ->
                    List.of(
                        zone.name(),
                        demanded(zone),
                        Integer.toString(zone.k()),
                        squareMetres(measured(zone).squareMetres()),
                        percent(plan.cover().claimedShare(zone)),
                        squareMetres(notMet(zone))))
            .toList();
    return new Section(
        "Zones",
        List.of(
            "zone",
            "asks for",
            "k",
            "area, m²",
            demand.isForArea() ? "met, of the area" : "met",
            "not seen as asked, m²"),
        rows);
  }

  private PlanArea.MeasuredZone measured(ZoneDemand zone) {
    return plan.cover().area().zones().get(demand.zones().indexOf(zone));
  }

  /** The area of all blind spots of a zone, in square metres. */
  private double notMet(ZoneDemand zone) {
    return plan.cover().blindSpots().stream()
        .filter(spot -> spot.zone().equals(zone.name()))
        .mapToDouble(BlindSpot::area)
        .sum();
  }

  private static String squareMetres(double area) {
    return Texts.format("%.1f", area);
  }

  /** The level that a zone asks for, and what it says of faces. */
  private String demanded(ZoneDemand demanded) {
    String level = DensityDetections.levelName(demanded.detection().name());
    return demand.site().zones().stream()
        .filter(zone -> zone.name().equals(demanded.name()))
        .findFirst()
        .map(zone -> level + ofFaces(zone))
        .orElse(level);
  }

  private static String ofFaces(Zone zone) {
    String facing =
        zone.facing() == null
            ? ""
            : Texts.format(
                "; faces that look to %.0f°, within %.0f°",
                (zone.facing() + 360) % 360, zone.tolerance());
    String depression =
        zone.maxDepression() == null
            ? ""
            : Texts.format("; seen from at most %.0f° above", zone.maxDepression());
    return facing + depression;
  }

  private static double unseenShare(ZoneDemand zone, int[] counts) {
    return Arrays.stream(counts, zone.first(), zone.end()).filter(count -> count == 0).count()
        / Math.max(1.0, zone.count());
  }

  private Section cameraTable() {
    List<List<String>> rows = new ArrayList<>();
    for (int i = 0; i < plan.cameras().size(); i++) {
      CameraSpec camera = plan.cameras().get(i);
      boolean kept = i < plan.keptCameras();
      int[] countsWithout = plan.cover().countsWithout(i);
      rows.add(
          List.of(
              camera.name(),
              Texts.format("%.2f", camera.x()),
              Texts.format("%.2f", camera.y()),
              height(camera),
              Texts.format("%.1f", (camera.heading() + 360) % 360),
              Texts.format("%.1f", camera.tilt()),
              camera.optics().map(OpticsSpec::name).orElse("own"),
              kept ? "stays" : money(camera.price()),
              Integer.toString(plan.cover().covered()[i].length),
              percent(plan.cover().share(countsWithout)),
              mostBlindZone(countsWithout)));
    }
    return new Section(
        "Cameras, and what if one fails",
        List.of(
            "camera",
            "x, m",
            "y, m",
            "z, m",
            "heading",
            "tilt",
            "lens",
            "price, " + currency,
            "cells",
            "cells met without it",
            "most goes blind in"),
        rows);
  }

  /**
   * Returns the name of the zone that loses the greatest share, with that share; empty if none
   * becomes blind.
   */
  private String mostBlindZone(int[] countsWithout) {
    ToDoubleFunction<ZoneDemand> lostShare =
        zone -> unseenShare(zone, countsWithout) - unseenShare(zone, counts);
    ZoneDemand worst =
        demand.zones().stream().max(Comparator.comparingDouble(lostShare)).orElseThrow();
    double share = lostShare.applyAsDouble(worst);
    return share > 0 ? worst.name() + ", " + percent(share) + " of it" : "";
  }

  private String height(CameraSpec camera) {
    double z = plan.height(camera);
    return Double.isNaN(z) ? "" : Texts.format("%.1f", z);
  }

  private Section blindSpotTable() {
    BlindSpot.Listing spots = BlindSpot.Listing.of(plan.cover().blindSpots(), MAX_SPOTS);
    Stream<List<String>> rest =
        spots.others() > 0
            ? Stream.of(List.of(spots.others() + " more", squareMetres(spots.otherArea()), "", ""))
            : Stream.of();
    return new Section(
        "Not seen as asked",
        List.of("zone", "square metres", "around x, m", "y, m"),
        Stream.concat(
                spots.shown().stream()
                    .map(
                        spot ->
                            List.of(
                                spot.zone(),
                                squareMetres(spot.area()),
                                Texts.format("%.1f", spot.x()),
                                Texts.format("%.1f", spot.y()))),
                rest)
            .toList());
  }

  private static String percent(double share) {
    return Texts.format("%.1f %%", 100 * share);
  }
}
