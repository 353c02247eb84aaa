package org.hificamsim.placement.output;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.placement.output.PlanSections.Section;
import org.hificamsim.placement.site.CameraPlan;
import org.hificamsim.placement.site.SitePlan.CurvePoint;
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
import org.hificamsim.runs.output.ManifestFile;

/** Writes a plan for clients: as a page, as a PDF of A4 pages, and the floor plan as SVG. */
final class PlanSheet {
  /** The heights of pictures, as shares of the height of a page. */
  private static final double PLAN_HEIGHT = 0.45;

  private static final double LEVELS_HEIGHT = 0.3;

  private static final double CURVE_HEIGHT = 0.15;

  private static final double POINTS_PER_METRE = 72 / 0.0254;

  /** The reason why there is no picture of levels. */
  static final String TWO_STANDARDS =
      "levels are not drawn, since the zones ask for those of two standards";

  /**
   * The content of documents in addition to the plan.
   *
   * @param floor the floor plan of the site
   * @param command the words of the command that made the plan
   */
  record Content(List<Setup.Floor> floor, TitleBlock title, String command) {}

  private final CameraPlan plan;
  private final Content content;
  private final PlanDrawing floor;
  private final Optional<PlanDrawing> detectionLevels;
  private final Optional<Figure> curve;
  private final List<Section> sections;

  /**
   * @param points the points of the curve of coverage; empty if no plan was searched for
   */
  PlanSheet(
      CameraPlan plan,
      Catalogue catalogue,
      CameraSectors sectors,
      List<CurvePoint> points,
      Content content) {
    this.plan = plan;
    this.content = content;
    this.floor = new PlanDrawing(plan, CellClasses.coverage(plan), sectors.all(), content.floor);
    this.detectionLevels =
        CellClasses.levels(plan, catalogue)
            .map(classes -> new PlanDrawing(plan, classes, List.of(), content.floor));
    this.curve =
        points.isEmpty() ? Optional.empty() : Optional.of(curve(points, content.title.currency()));
    this.sections = new PlanSections(plan, content.title.currency()).sections();
  }

  private String title() {
    return "Camera plan of " + plan.demand().site().name();
  }

  /** The reason why a picture is missing; empty if all are drawn. */
  static Optional<String> omission(CameraPlan plan) {
    return CellClasses.asksForTwoStandards(plan) ? Optional.of(TWO_STANDARDS) : Optional.empty();
  }

  /** Draws the share over the price, or over the number of cameras if the plan is for a number. */
  private static Figure curve(List<CurvePoint> points, String currency) {
    boolean isByNumber = points.stream().allMatch(point -> point.price() == point.cameras());
    double[] prices = points.stream().mapToDouble(CurvePoint::price).toArray();
    double[] shares = points.stream().mapToDouble(point -> 100 * point.share()).toArray();
    double[] bounds = points.stream().mapToDouble(point -> 100 * point.bound()).toArray();
    double top = Math.max(shares[shares.length - 1], bounds[bounds.length - 1]);
    XyPanel panel =
        new XyPanel("", isByNumber ? "new cameras" : "price, " + currency, "% of the samples")
            .x(0, Math.max(1, prices[prices.length - 1]))
            .y(0, Math.min(100, 10 * Math.ceil(0.1 + top / 10)))
            .straight(new Curve(prices, bounds), Palette.GREY)
            .straight(new Curve(prices, shares), Palette.BLUE);
    List<LegendEntry> legend =
        List.of(
            new LegendEntry("met by the plan", Palette.BLUE, LegendEntry.Mark.LINE),
            new LegendEntry("bound for the candidates", Palette.GREY, LegendEntry.Mark.LINE));
    return new Figure("", "", legend, List.of(panel), 1, 500, 240);
  }

  /** Writes {@code index.html}, {@code plan.pdf}, {@code plan.svg} and {@code levels.svg}. */
  void write(OutputFolder folder) throws IOException {
    folder.write("index.html", page().html());
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
    pages.text(List.of(String.join("; ", titleEntries())));
    pages.text(facts());
    pages.picture(floor, PLAN_HEIGHT);
    sections.forEach(section -> pages.table(section.title(), section.columns(), section.rows()));
    if (detectionLevels.isPresent()) {
      pages.picture("Levels reached", detectionLevels.get(), LEVELS_HEIGHT);
    }
    curve.ifPresent(figure -> pages.picture("What each camera adds", figure, CURVE_HEIGHT));
    return pages.pages();
  }

  private List<String> titleEntries() {
    List<String> entries = new ArrayList<>();
    content.title.entries().forEach((key, value) -> entries.add(key + ": " + value));
    double pointsPerMetre = floor.pointsPerMetre() * A4Pages.scale(floor, PLAN_HEIGHT);
    entries.add(Texts.format("scale: about 1:%.0f on A4", POINTS_PER_METRE / pointsPerMetre));
    entries.add("prices: " + content.title.currency());
    return entries;
  }

  private List<String> facts() {
    List<String> facts = new ArrayList<>(plan.facts());
    if (CellClasses.asksForTwoStandards(plan)) {
      facts.add(TWO_STANDARDS);
    }
    return facts;
  }

  private Page page() throws IOException {
    ObjectNode data = new ObjectMapper().createObjectNode();
    data.put("title", title()).put("command", content.command);
    data.put("version", ManifestFile.version());
    data.put("floor", image(floor));
    data.put("curve", curve.isPresent() ? image(curve.get()) : null);
    data.put("levels", detectionLevels.isPresent() ? image(detectionLevels.get()) : null);
    facts().forEach(data.putArray("facts")::add);
    ArrayNode block = data.putArray("block");
    content.title.entries().forEach((key, value) -> block.addArray().add(key).add(value));
    ArrayNode tablesJson = data.putArray("tables");
    for (Section table : sections) {
      ObjectNode tableJson = tablesJson.addObject().put("title", table.title());
      table.columns().forEach(tableJson.putArray("columns")::add);
      ArrayNode rows = tableJson.putArray("rows");
      table.rows().forEach(row -> row.forEach(rows.addArray()::add));
    }
    return new Page(title(), "plan-page.js", "planPage", data.toString());
  }

  private static String image(Paintable picture) throws IOException {
    ByteArrayOutputStream svg = new ByteArrayOutputStream();
    FigureFile.svg(svg, picture);
    return "data:image/svg+xml;base64," + Base64.getEncoder().encodeToString(svg.toByteArray());
  }
}
