package org.hificamsim.placement.output;

import java.util.List;
import java.util.stream.Collectors;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.OpticsSpec;
import org.hificamsim.placement.site.Candidates.Candidate;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.SitePlan;
import org.hificamsim.placement.site.SitePlan.Reached;
import org.hificamsim.runs.output.Column;
import org.hificamsim.runs.output.Table;

/** The tables of a plan. */
final class PlanTables {
  private static final String LIST = "degrees, between spaces";

  /** A camera of the plan with its price, what it covers, and the share met without it. */
  record Planned(CameraSpec camera, double price, int covers, double without) {}

  /** A sample with the number of cameras that cover it, and its multiplier. */
  record Covered(SitePlan plan, Demand.Sample sample, int count, double multiplier) {}

  /** A zone with how often each sample is covered. */
  record Met(Demand demand, Demand.Watched zone, int[] counts) {}

  /** A row per camera, those that stay first. */
  static final Table<Planned> CAMERAS =
      Table.<Planned>of("cameras.csv")
          .with(camera(), Planned::camera)
          .with(
              Column.ofPlain("price", "as in the catalogue", "0 of one that stays", Planned::price),
              Column.ofInt("covers", "samples", "that it covers", Planned::covers),
              Column.ofDouble(
                  "share_without", "share of the demand", "met if it fails", Planned::without));

  /** A row per candidate. */
  static final Table<Candidate> CANDIDATES =
      Table.<Candidate>of("candidates.csv")
          .with(Column.ofText("kind", "its name in the catalogue", one -> one.kind().name()))
          .with(camera(), one -> one.camera(""))
          .with(
              Column.ofPlain(
                  "price", "as in the catalogue", "", (Candidate one) -> one.kind().price()));

  /** A row per place that is to be seen. */
  static final Table<Covered> SAMPLES =
      Table.<Covered>of("samples.csv")
          .with(
              Column.ofText("zone", "its zone", row -> zone(row).name()),
              Column.ofDouble("x", "m", "", row -> row.sample.x()),
              Column.ofDouble("y", "m", "", row -> row.sample.y()),
              Column.ofPlain("weight", "", "what seeing it is worth", row -> row.sample.weight()),
              Column.ofInt("needs", "cameras", "that it needs", row -> zone(row).k()),
              Column.ofInt("seen", "cameras", "that cover it", Covered::count),
              Column.ofDouble(
                  "multiplier",
                  "",
                  "the price of seeing it once by which the bound is proven",
                  Covered::multiplier));

  /** A row per zone. */
  static final Table<Met> ZONES =
      Table.<Met>of("zone-plan.csv")
          .with(
              Column.ofText("zone", "", row -> row.zone.name()),
              Column.ofText(
                  "detection", "what has to see there", row -> row.zone.detection().name()),
              Column.ofInt("k", "cameras", "that have to", row -> row.zone.k()),
              Column.ofInt("samples", "samples", "", row -> row.zone.count()),
              Column.ofDouble("share", "share of the demand", "met", row -> share(row, false)),
              Column.ofDouble(
                  "share_whole", "share of the demand", "met by all k", row -> share(row, true)));

  /** A row per number of new cameras. */
  static final Table<Reached> CURVE =
      Table.<Reached>of("curve.csv")
          .with(
              Column.ofInt("cameras", "cameras", "those that add most first", Reached::cameras),
              Column.ofPlain("price", "as asked", "of these", Reached::price),
              Column.ofDouble("share", "share of the demand", "met by them", Reached::share),
              Column.ofDouble(
                  "bound", "share of the demand", "no plan meets more", Reached::bound));

  private PlanTables() {}

  private static double share(Met row, boolean whole) {
    return row.demand.share(row.zone, row.counts, whole);
  }

  private static Demand.Watched zone(Covered row) {
    return row.plan.demand().zones().get(row.sample.zone());
  }

  private static List<Column<CameraSpec>> camera() {
    return List.of(
        Column.ofText("camera", "its name", CameraSpec::name),
        Column.ofDouble("x", "m", "", CameraSpec::x),
        Column.ofDouble("y", "m", "", CameraSpec::y),
        Column.ofDouble("heading", "degrees", "0 is +y, 90 is +x", CameraSpec::heading),
        Column.ofText(
            "law", "of its lens", one -> one.optics().map(o -> o.law().name()).orElse("")),
        Column.ofDouble("reach", "m", "of its lens, if it ends", one -> reach(one)),
        Column.ofInt("pixels", "pixels", "across", one -> pixels(one)),
        Column.ofText("hfov", "angles of view, " + LIST, one -> list(one, true)),
        Column.ofText("pan", "off its heading, " + LIST, one -> list(one, false)));
  }

  private static int pixels(CameraSpec camera) {
    return camera.optics().flatMap(OpticsSpec::pixels).orElse(0);
  }

  private static double reach(CameraSpec camera) {
    return camera.optics().map(one -> one.reach().orElse(Double.NaN)).orElse(Double.NaN);
  }

  private static String list(CameraSpec camera, boolean angles) {
    return camera.optics().stream()
        .flatMap(one -> (angles ? one.anglesOfView() : one.pans()).stream())
        .map(String::valueOf)
        .collect(Collectors.joining(" "));
  }
}
