package org.hificamsim.placement.output;

import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.OpticsSpec;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.SitePlan.Reached;
import org.hificamsim.runs.output.Column;
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
          .with(
              Column.ofText("camera", "its name", row -> row.camera.name()),
              Column.ofDouble("x", "m", "", row -> row.camera.x()),
              Column.ofDouble("y", "m", "", row -> row.camera.y()),
              Column.ofDouble(
                  "heading", "degrees", "0 is +y, 90 is +x", row -> row.camera.heading()),
              Column.ofDouble(
                  "z", "m", "where it has a height", row -> row.camera.z().orElse(Double.NaN)),
              Column.ofDouble("tilt", "degrees", "downwards", row -> row.camera.tilt()),
              Column.ofText(
                  "lens",
                  "its optics",
                  row -> row.camera.optics().map(OpticsSpec::name).orElse("")),
              Column.ofPlain("price", "as in the catalogue", "0 of one that stays", Planned::price),
              Column.ofInt("covers", "samples", "that it covers", Planned::covers),
              Column.ofDouble("share_without", SHARE, "met if it fails", Planned::without));

  /** A row per place that is to be seen. */
  static final Table<Covered> SAMPLES =
      Table.<Covered>of("samples.csv")
          .with(
              Column.ofText("zone", "its zone", row -> row.zone.name()),
              Column.ofDouble("x", "m", "", row -> row.sample.x()),
              Column.ofDouble("y", "m", "", row -> row.sample.y()),
              Column.ofPlain("weight", "", "what seeing it is worth", row -> row.sample.weight()),
              Column.ofInt("needs", "cameras", "that it needs", row -> row.zone.k()),
              Column.ofInt("seen", "cameras", "that cover it", Covered::count),
              Column.ofDouble(
                  "multiplier",
                  "",
                  "the price of seeing it once by which the bound is proven",
                  Covered::multiplier));

  /** A row per number of new cameras. */
  static final Table<Reached> CURVE =
      Table.<Reached>of("curve.csv")
          .with(
              Column.ofInt("cameras", "cameras", "those that add most first", Reached::cameras),
              Column.ofPlain("price", "as asked", "of these", Reached::price),
              Column.ofDouble("share", SHARE, "met by them", Reached::share),
              Column.ofDouble(
                  "bound", SHARE, "candidates at the price meet no more", Reached::bound));

  private PlanTables() {}
}
