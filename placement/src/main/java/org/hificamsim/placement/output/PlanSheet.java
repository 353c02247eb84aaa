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
import org.hificamsim.placement.site.SampleSight;
import org.hificamsim.placement.site.SitePlan;
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

/** A plan to be handed on: a page, a PDF of A4, and the floor plan as SVG. */
final class PlanSheet {
  private static final int MOST_SPOTS = 25;

  private record Listing(String title, List<String> columns, List<List<String>> rows) {}

  private final SitePlan plan;
  private final Demand demand;
  private final int[] counts;
  private final Paintable floor;
  private final Optional<Paintable> levels;
  private final Figure curve;
  private final List<Listing> listings;

  PlanSheet(SitePlan plan, Catalogue catalogue, List<Setup.Floor> floor) {
    this.plan = plan;
    this.demand = plan.demand();
    this.counts = plan.counts();
    this.floor =
        picture(
            catalogue,
            floor,
            classes(),
            List.of(Palette.UNSEEN, Palette.SEEN_ONCE, Palette.SEEN_OFTEN),
            List.of("seen by no camera", "by fewer than asked for", "as asked for"));
    this.levels = levels(catalogue, floor);
    this.curve = curve();
    this.listings = List.of(zones(), cameras(), spots());
  }

  private Paintable picture(
      Catalogue catalogue,
      List<Setup.Floor> floor,
      double[] classes,
      List<Color> colors,
      List<String> signs) {
    return new PlanPicture(
        new World(plan.scenario(), catalogue.movements(), 0),
        demand.zones().get(0).detection(),
        catalogue.policies().create("fixed"),
        floor,
        demand.cells(),
        classes,
        colors,
        signs);
  }

  /** The highest level of their standard that is reached, where zones ask for one. */
  private Optional<Paintable> levels(Catalogue catalogue, List<Setup.Floor> floor) {
    List<String> asked = demand.zones().stream().map(zone -> zone.detection().name()).toList();
    List<String> names =
        asked.stream().flatMap(one -> DensityDetections.levels(one).stream()).distinct().toList();
    if (names.isEmpty() || names.size() > Palette.LEVELS.size()) { // of two standards
      return Optional.empty();
    }
    double[] reached = classes();
    Arrays.setAll(reached, cell -> 0 * reached[cell]);
    List<Color> colors = new ArrayList<>(List.of(Palette.UNSEEN));
    List<String> signs = new ArrayList<>(List.of("none"));
    for (String name : names) {
      Detection level = Detection.of(catalogue.detections().create(name));
      colors.add(Palette.LEVELS.get(signs.size() - 1));
      signs.add(
          name.replaceFirst(".*=", "") + (asked.contains(level.name()) ? " (asked for)" : ""));
      int[][] seen =
          new SampleSight(demand.by(level), catalogue)
              .covered(plan.cameras(), plan.problem().reading());
      for (int sample : Arrays.stream(seen).flatMapToInt(Arrays::stream).toArray()) {
        Demand.Sample at = demand.samples().get(sample);
        reached[demand.cells().at(at.x(), at.y())] = signs.size() - 1;
      }
    }
    return Optional.of(picture(catalogue, floor, reached, colors, signs));
  }

  /** By cell: 0 unseen, 1 seen by fewer cameras than a zone asks for, 2 as all its zones ask. */
  private double[] classes() {
    double[] classes = new double[demand.cells().count()];
    Arrays.fill(classes, Double.NaN);
    for (int s = 0; s < counts.length; s++) {
      Demand.Sample sample = demand.samples().get(s);
      int met = counts[s] == 0 ? 0 : counts[s] < demand.zones().get(sample.zone()).k() ? 1 : 2;
      int cell = demand.cells().at(sample.x(), sample.y());
      classes[cell] = Double.isNaN(classes[cell]) ? met : Math.min(classes[cell], met);
    }
    return classes;
  }

  private String title() {
    return "Camera plan of " + demand.site().name();
  }

  private Figure curve() {
    List<SitePlan.Reached> points = plan.curve();
    double[] cameras = points.stream().mapToDouble(SitePlan.Reached::cameras).toArray();
    double[] met = points.stream().mapToDouble(one -> 100 * one.share()).toArray();
    double[] most = points.stream().mapToDouble(one -> 100 * one.bound()).toArray();
    double top = Math.max(met[met.length - 1], most[most.length - 1]);
    XyPanel panel =
        new XyPanel("", "new cameras", "% of the demand")
            .x(0, Math.max(1, cameras[cameras.length - 1]))
            .y(0, Math.min(100, 10 * Math.ceil(0.1 + top / 10)))
            .straight(new Curve(cameras, most), Palette.GREY)
            .straight(new Curve(cameras, met), Palette.BLUE);
    List<LegendEntry> legend =
        List.of(
            new LegendEntry("met by the plan", Palette.BLUE, LegendEntry.Mark.LINE),
            new LegendEntry("bound for the candidates", Palette.GREY, LegendEntry.Mark.LINE));
    return new Figure("", "", legend, List.of(panel), 1, 500, 240);
  }

  private Listing zones() {
    List<List<String>> rows =
        demand.zones().stream()
            .map(
                zone ->
                    List.of(
                        zone.name(),
                        zone.detection().name(),
                        Integer.toString(zone.k()),
                        Integer.toString(zone.count()),
                        percent(demand.share(zone, counts, false)),
                        percent(demand.share(zone, counts, true)),
                        percent(unseen(zone, counts))))
            .toList();
    return new Listing(
        "Zones", List.of("zone", "asks for", "k", "cells", "met", "met by k", "unseen"), rows);
  }

  private static double unseen(Demand.Watched zone, int[] counts) {
    return Arrays.stream(counts, zone.first(), zone.end()).filter(k -> k == 0).count()
        / Math.max(1.0, zone.count());
  }

  private Listing cameras() {
    List<List<String>> rows = new ArrayList<>();
    for (int i = 0; i < plan.cameras().size(); i++) {
      CameraSpec camera = plan.cameras().get(i);
      boolean kept = i < plan.problem().kept().size();
      int[] left = plan.countsWithout(i);
      rows.add(
          List.of(
              camera.name(),
              Texts.format("%.2f", camera.x()),
              Texts.format("%.2f", camera.y()),
              height(camera),
              Texts.format("%.1f", camera.heading()),
              Texts.format("%.1f", camera.tilt()),
              camera.optics().map(OpticsSpec::name).orElse("own"),
              kept ? "stays" : Texts.format("%.2f", plan.prices().get(i)),
              Integer.toString(plan.covered()[i].length),
              percent(plan.share(left)),
              blind(left)));
    }
    return new Listing(
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

  /** The zone of which most is unseen that was not before. */
  private String blind(int[] left) {
    ToDoubleFunction<Demand.Watched> lost = zone -> unseen(zone, left) - unseen(zone, counts);
    Demand.Watched worst =
        demand.zones().stream().max(Comparator.comparingDouble(lost)).orElseThrow();
    double share = lost.applyAsDouble(worst);
    return share > 0 ? worst.name() + ", " + percent(share) + " of it" : "";
  }

  private String height(CameraSpec camera) {
    double z = camera.z().orElse(demand.site().mountHeight().orElse(Double.NaN));
    return Double.isNaN(z) ? "" : Texts.format("%.1f", z);
  }

  private Listing spots() {
    List<BlindSpot> spots = plan.blindSpots();
    double small = spots.stream().skip(MOST_SPOTS).mapToDouble(BlindSpot::area).sum();
    Stream<List<String>> rest =
        small > 0
            ? Stream.of(
                List.of(spots.size() - MOST_SPOTS + " more", Texts.format("%.1f", small), "", ""))
            : Stream.of();
    return new Listing(
        "Seen by no camera",
        List.of("zone", "square metres", "around x, m", "y, m"),
        Stream.concat(
                spots.stream()
                    .limit(MOST_SPOTS)
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

  /** Writes {@code index.html}, {@code plan.pdf}, {@code plan.svg}. */
  void write(OutputFolder folder, String command, String version) throws IOException {
    folder.write("index.html", page(command, version).html());
    try (OutputStream out = folder.stream("plan.pdf")) {
      FigureFile.pages(out, pages());
    }
    try (OutputStream out = folder.stream("plan.svg")) {
      FigureFile.svg(out, floor);
    }
    if (levels.isPresent()) {
      try (OutputStream out = folder.stream("levels.svg")) {
        FigureFile.svg(out, levels.get());
      }
    }
  }

  private List<Paintable> pages() {
    A4Pages pages = new A4Pages(title());
    pages.heading(title());
    pages.text(plan.facts());
    pages.picture(floor, 0.62);
    if (levels.isPresent()) {
      pages.heading("Levels reached");
      pages.picture(levels.get(), 0.62);
    }
    pages.heading("Coverage over the number of cameras");
    pages.picture(curve, 0.3);
    for (Listing listing : listings) {
      if (!listing.rows.isEmpty()) {
        pages.heading(listing.title);
        pages.table(listing.columns, listing.rows);
      }
    }
    return pages.pages();
  }

  private Page page(String command, String version) throws IOException {
    ObjectNode data = new ObjectMapper().createObjectNode();
    data.put("title", title()).put("command", command).put("version", version);
    data.put("floor", image(floor)).put("curve", image(curve));
    data.put("levels", levels.isPresent() ? image(levels.get()) : null);
    plan.facts().forEach(data.putArray("facts")::add);
    ArrayNode tables = data.putArray("tables");
    for (Listing listing : listings) {
      ObjectNode table = tables.addObject().put("title", listing.title);
      listing.columns.forEach(table.putArray("columns")::add);
      ArrayNode rows = table.putArray("rows");
      listing.rows.forEach(row -> row.forEach(rows.addArray()::add));
    }
    return new Page(title(), "plan-page.js", "planPage", data.toString());
  }

  private static String image(Paintable picture) throws IOException {
    ByteArrayOutputStream svg = new ByteArrayOutputStream();
    FigureFile.svg(svg, picture);
    return "data:image/svg+xml;base64," + Base64.getEncoder().encodeToString(svg.toByteArray());
  }
}
