package org.hificamsim.placement.output;

import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.SitePlan.Reached;
import org.hificamsim.runs.output.Table;

/** The tables of a plan. */
final class PlanTables {
  private static final String SHARE = "share of the demand";

  /** A camera of the plan with its price, what it covers, and the share met without it. */
  record Planned(CameraSpec camera, double price, int covers, double without) {}

  /** A sample with the number of cameras that cover it, and its multiplier. */
  record Covered(Demand.Watched zone, Demand.Sample sample, int count, double multiplier) {}

  /** A row per camera, those that stay first. */
  static final Table<Planned> CAMERAS =
      Table.<Planned>of("cameras.csv")
          .texts("camera", "its name", row -> row.camera.name())
          .doubles("x", "m", "", row -> row.camera.x())
          .doubles("y", "m", "", row -> row.camera.y())
          .doubles("heading", "degrees", "0 is +y, 90 is +x", row -> row.camera.heading())
          .doubles("z", "m", "where it has a height", row -> row.camera.z().orElse(Double.NaN))
          .doubles("tilt", "degrees", "downwards", row -> row.camera.tilt())
          .texts("lens", "its optics", row -> row.camera.optics().map(OpticsSpec::name).orElse(""))
          .plain("price", "as in the catalogue", "0 of one that stays", Planned::price)
          .ints("covers", "samples", "that it covers", Planned::covers)
          .doubles("share_without", SHARE, "met if it fails", Planned::without);

  /** A row per place that is to be seen. */
  static final Table<Covered> SAMPLES =
      Table.<Covered>of("samples.csv")
          .texts("zone", "its zone", row -> row.zone.name())
          .doubles("x", "m", "", row -> row.sample.x())
          .doubles("y", "m", "", row -> row.sample.y())
          .plain("weight", "", "what seeing it is worth", row -> row.sample.weight())
          .ints("needs", "cameras", "that it needs", row -> row.zone.k())
          .ints("seen", "cameras", "that cover it", Covered::count)
          .doubles(
              "multiplier",
              "",
              "the price of seeing it once by which the bound is proven",
              Covered::multiplier);

  /** A row per number of new cameras. */
  static final Table<Reached> CURVE =
      Table.<Reached>of("curve.csv")
          .ints("cameras", "cameras", "those that add most first", Reached::cameras)
          .plain("price", "as asked", "of these", Reached::price)
          .doubles("share", SHARE, "met by them", Reached::share)
          .doubles("bound", SHARE, "candidates at the price meet no more", Reached::bound);

  private PlanTables() {}
}
