package org.hificamsim.placement.output;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.Color;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.world.World;
import org.hificamsim.hifi.density.DensityDetections;
import org.hificamsim.placement.site.BlindSpot;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.Demand.DemandPoint;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.placement.site.PointSight;
import org.hificamsim.placement.site.SitePlan;
import org.hificamsim.placement.site.SitePlan.CurvePoint;
import org.hificamsim.presentation.picture.PlanPicture;
import org.hificamsim.presentation.plot.A4Pages;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Paintable;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.presentation.report.Page;

/** A plan to hand on to a client: a page, a PDF of A4 pages, and the floor plan as SVG. */
final class PlanSheet {
  private static final int MAX_SPOTS = 25;

  /** The heights of pictures, as shares of the height of a page. */
  private static final double PLAN_HEIGHT = 0.62;

  private static final double CURVE_HEIGHT = 0.3;

  private record PlanTable(String title, List<String> columns, List<List<String>> rows) {}

  private final SitePlan plan;
  private final Demand demand;
  private final int[] counts;
  private final Paintable floor;
  private final Optional<Paintable> detectionLevels;
  private final Figure curve;
  private final List<PlanTable> tables;

  PlanSheet(SitePlan plan, Catalogue catalogue, List<Setup.Floor> floor) {
    this.plan = plan;
    this.demand = plan.demand();
    this.counts = plan.cover().counts();
    this.floor =
        picture(
            catalogue,
            floor,
            coverageClasses(),
            List.of(Palette.UNSEEN, Palette.SEEN_ONCE, Palette.SEEN_OFTEN),
            List.of("seen by no camera", "by fewer than asked for", "as asked for"));
    this.detectionLevels = detectionLevels(catalogue, floor);
    this.curve = curve();
    this.tables = List.of(zoneTable(), cameraTable(), blindSpotTable());
  }

  private Paintable picture(
      Catalogue catalogue,
      List<Setup.Floor> floor,
      double[] classes,
      List<Color> colors,
      List<String> labels) {
    return new PlanPicture(
        new World(plan.scenario(), catalogue.movements(), 0),
        demand.zones().get(0).detection(),
        catalogue.policies().create("fixed"),
        floor,
        new PlanPicture.ClassifiedCells(demand.cells(), classes, colors, labels));
  }

  /**
   * The highest level of a standard that is reached in each cell, if all zones that ask for a level
   * use the same standard.
   */
  private Optional<Paintable> detectionLevels(Catalogue catalogue, List<Setup.Floor> floor) {
    List<String> asked = demand.zones().stream().map(zone -> zone.detection().name()).toList();
    List<String> names =
        asked.stream()
            .flatMap(detection -> DensityDetections.levels(detection).stream())
            .distinct()
            .toList();
    boolean oneStandard = names.size() <= Palette.SEQUENCE.size();
    if (names.isEmpty() || !oneStandard) {
      return Optional.empty();
    }
    double[] reached = coverageClasses();
    Arrays.setAll(reached, cell -> 0 * reached[cell]); // cells without a point stay NaN
    List<Color> colors = new ArrayList<>(List.of(Palette.UNSEEN));
    List<String> labels = new ArrayList<>(List.of("none"));
    for (String name : names) {
      Detection detection = Detection.of(catalogue.detections().create(name));
      colors.add(Palette.SEQUENCE.get(labels.size() - 1));
      String suffix = asked.contains(detection.name()) ? " (asked for)" : "";
      labels.add(name.replaceFirst(".*=", "") + suffix);
      int[][] seen =
          new PointSight(demand.with(detection), catalogue)
              .covered(plan.cameras(), plan.problem().request().reading());
      for (int number : Arrays.stream(seen).flatMapToInt(Arrays::stream).toArray()) {
        DemandPoint point = demand.points().get(number);
        reached[demand.cells().at(point.x(), point.y())] = labels.size() - 1;
      }
    }
    return Optional.of(picture(catalogue, floor, reached, colors, labels));
  }

  /**
   * By cell: 0 if it is seen by no camera, 1 if by fewer than one of its zones asks for, 2 if as
   * all its zones ask, NaN if it is not to be seen.
   */
  private double[] coverageClasses() {
    double[] classes = new double[demand.cells().count()];
    Arrays.fill(classes, Double.NaN);
    for (int number = 0; number < counts.length; number++) {
      DemandPoint point = demand.points().get(number);
      int count = counts[number];
      int pointClass = count == 0 ? 0 : count < demand.zones().get(point.zone()).k() ? 1 : 2;
      int cell = demand.cells().at(point.x(), point.y());
      double before = classes[cell];
      classes[cell] = Double.isNaN(before) ? pointClass : Math.min(before, pointClass);
    }
    return classes;
  }

  private String title() {
    return "Camera plan of " + demand.site().name();
  }

  private Figure curve() {
    List<CurvePoint> points = plan.curve();
    double[] cameras = points.stream().mapToDouble(CurvePoint::cameras).toArray();
    double[] shares = points.stream().mapToDouble(point -> 100 * point.share()).toArray();
    double[] bounds = points.stream().mapToDouble(point -> 100 * point.bound()).toArray();
    double top = Math.max(shares[shares.length - 1], bounds[bounds.length - 1]);
    XyPanel panel =
        new XyPanel("", "new cameras", "% of the demand")
            .x(0, Math.max(1, cameras[cameras.length - 1]))
            .y(0, Math.min(100, 10 * Math.ceil(0.1 + top / 10)))
            .straight(new Curve(cameras, bounds), Palette.GREY)
            .straight(new Curve(cameras, shares), Palette.BLUE);
    List<LegendEntry> legend =
        List.of(
            new LegendEntry("met by the plan", Palette.BLUE, LegendEntry.Mark.LINE),
            new LegendEntry("bound for the candidates", Palette.GREY, LegendEntry.Mark.LINE));
    return new Figure("", "", legend, List.of(panel), 1, 500, 240);
  }

  private PlanTable zoneTable() {
    List<List<String>> rows =
        demand.zones().stream()
            .map(
                zone ->
                    List.of(
                        zone.name(),
                        zone.detection().name(),
                        Integer.toString(zone.k()),
                        Integer.toString(zone.count()),
                        percent(plan.cover().claimedShare(zone)),
                        percent(demand.shareByK(zone, counts)),
                        percent(unseenShare(zone, counts))))
            .toList();
    return new PlanTable(
        "Zones", List.of("zone", "asks for", "k", "cells", "met", "met by k", "unseen"), rows);
  }

  private static double unseenShare(ZoneDemand zone, int[] counts) {
    return Arrays.stream(counts, zone.first(), zone.end()).filter(count -> count == 0).count()
        / Math.max(1.0, zone.count());
  }

  private PlanTable cameraTable() {
    List<List<String>> rows = new ArrayList<>();
    for (int i = 0; i < plan.cameras().size(); i++) {
      CameraSpec camera = plan.cameras().get(i);
      boolean kept = i < plan.problem().kept().size();
      int[] countsWithout = plan.cover().countsWithout(i);
      rows.add(
          List.of(
              camera.name(),
              Texts.format("%.2f", camera.x()),
              Texts.format("%.2f", camera.y()),
              height(camera),
              Texts.format("%.1f", camera.heading()),
              Texts.format("%.1f", camera.tilt()),
              camera.optics().map(OpticsSpec::name).orElse("own"),
              kept ? "stays" : Texts.format("%.2f", camera.price()),
              Integer.toString(plan.cover().covered()[i].length),
              percent(plan.cover().share(countsWithout)),
              mostBlindZone(countsWithout)));
    }
    return new PlanTable(
        "Cameras, and what if one fails",
        List.of(
            "camera",
            "x, m",
            "y, m",
            "z, m",
            "heading",
            "tilt",
            "lens",
            "price",
            "cells",
            "met without it",
            "most goes blind in"),
        rows);
  }

  /** The zone that loses most of its cover, with the share that becomes blind; may be empty. */
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

  private PlanTable blindSpotTable() {
    List<BlindSpot> spots = plan.cover().blindSpots();
    double restArea = spots.stream().skip(MAX_SPOTS).mapToDouble(BlindSpot::area).sum();
    Stream<List<String>> rest =
        restArea > 0
            ? Stream.of(
                List.of(spots.size() - MAX_SPOTS + " more", Texts.format("%.1f", restArea), "", ""))
            : Stream.of();
    return new PlanTable(
        "Seen by no camera",
        List.of("zone", "square metres", "around x, m", "y, m"),
        Stream.concat(
                spots.stream()
                    .limit(MAX_SPOTS)
                    .map(
                        spot ->
                            List.of(
                                spot.zone(),
                                Texts.format("%.1f", spot.area()),
                                Texts.format("%.1f", spot.x()),
                                Texts.format("%.1f", spot.y()))),
                rest)
            .toList());
  }

  private static String percent(double share) {
    return Texts.format("%.1f %%", 100 * share);
  }

  /** Writes {@code index.html}, {@code plan.pdf}, {@code plan.svg} and {@code levels.svg}. */
  void write(OutputFolder folder, String command, String version) throws IOException {
    folder.write("index.html", page(command, version).html());
    try (OutputStream out = folder.stream("plan.pdf")) {
      FigureFile.pages(out, pages());
    }
    try (OutputStream out = folder.stream("plan.svg")) {
      FigureFile.svg(out, floor);
    }
    if (detectionLevels.isPresent()) {
      try (OutputStream out = folder.stream("levels.svg")) {
        FigureFile.svg(out, detectionLevels.get());
      }
    }
  }

  private List<Paintable> pages() {
    A4Pages pages = new A4Pages(title());
    pages.heading(title());
    pages.text(plan.facts());
    pages.picture(floor, PLAN_HEIGHT);
    if (detectionLevels.isPresent()) {
      pages.heading("Levels reached");
      pages.picture(detectionLevels.get(), PLAN_HEIGHT);
    }
    pages.heading("Coverage over the number of cameras");
    pages.picture(curve, CURVE_HEIGHT);
    for (PlanTable table : tables) {
      if (!table.rows.isEmpty()) {
        pages.heading(table.title);
        pages.table(table.columns, table.rows);
      }
    }
    return pages.pages();
  }

  private Page page(String command, String version) throws IOException {
    ObjectNode data = new ObjectMapper().createObjectNode();
    data.put("title", title()).put("command", command).put("version", version);
    data.put("floor", image(floor)).put("curve", image(curve));
    data.put("levels", detectionLevels.isPresent() ? image(detectionLevels.get()) : null);
    plan.facts().forEach(data.putArray("facts")::add);
    ArrayNode tablesJson = data.putArray("tables");
    for (PlanTable table : tables) {
      ObjectNode tableJson = tablesJson.addObject().put("title", table.title);
      table.columns.forEach(tableJson.putArray("columns")::add);
      ArrayNode rows = tableJson.putArray("rows");
      table.rows.forEach(row -> row.forEach(rows.addArray()::add));
    }
    return new Page(title(), "plan-page.js", "planPage", data.toString());
  }

  private static String image(Paintable picture) throws IOException {
    ByteArrayOutputStream svg = new ByteArrayOutputStream();
    FigureFile.svg(svg, picture);
    return "data:image/svg+xml;base64," + Base64.getEncoder().encodeToString(svg.toByteArray());
  }
}
