package org.hificamsim.placement.output;

import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.placement.site.Demand.DemandPoint;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.placement.site.SitePlan.CurvePoint;
import org.hificamsim.runs.output.Table;

/** The tables of a plan. */
final class PlanTables {
  private static final String SHARE = "share of the demand";

  /**
   * A camera of the plan.
   *
   * @param z the height at which it hangs, in metres; NaN in a world without heights
   * @param coveredPoints the number of points that it covers
   * @param shareWithout the share of the demand that is met without it
   */
  record CameraRow(CameraSpec camera, double z, int coveredPoints, double shareWithout) {}

  /**
   * A point of the demand.
   *
   * @param count the number of cameras that cover it
   * @param multiplier the price of covering it once, by which the bound is proven
   */
  record PointRow(ZoneDemand zone, DemandPoint point, int count, double multiplier) {}

  /** A row for each product to order. */
  static final Table<PlanOrder.Product> ORDER =
      Table.<PlanOrder.Product>of("order.csv")
          .texts("camera", "its name in the catalogue", PlanOrder.Product::name)
          .ints("quantity", "cameras", "to order", PlanOrder.Product::quantity)
          .plain("price", "currency", "of one", PlanOrder.Product::price)
          .plain("total", "currency", "of all of these", PlanOrder.Product::total)
          .texts("currency", "the currency of the prices", PlanOrder.Product::currency);

  /** A row for each camera; those that stay come first. */
  static final Table<CameraRow> CAMERAS =
      Table.<CameraRow>of("cameras.csv")
          .texts("camera", "its name", row -> row.camera.name())
          .doubles("x", "m", "", row -> row.camera.x())
          .doubles("y", "m", "", row -> row.camera.y())
          .doubles("heading", "degrees", "0 is +y, 90 is +x", row -> row.camera.heading())
          .doubles("z", "m", "where it has a height", CameraRow::z)
          .doubles("tilt", "degrees", "downwards", row -> row.camera.tilt())
          .texts("lens", "its optics", row -> row.camera.optics().map(OpticsSpec::name).orElse(""))
          .plain("price", "as in the catalogue", "0 if it is not known", row -> row.camera.price())
          .ints("covers", "samples", "that it covers", CameraRow::coveredPoints)
          .doubles("share_without", SHARE, "met if it fails", CameraRow::shareWithout);

  /** A row for each point of the demand, which files call a sample. */
  static final Table<PointRow> POINTS =
      Table.<PointRow>of("samples.csv")
          .texts("zone", "its zone", row -> row.zone.name())
          .doubles("x", "m", "", row -> row.point.x())
          .doubles("y", "m", "", row -> row.point.y())
          .plain("weight", "", "what seeing it is worth", row -> row.point.weight())
          .ints("needs", "cameras", "that it needs", row -> row.zone.k())
          .ints("seen", "cameras", "that cover it", PointRow::count)
          .doubles(
              "multiplier",
              "",
              "the price of seeing it once by which the bound is proven",
              PointRow::multiplier);

  /** A row for each number of new cameras. */
  static final Table<CurvePoint> CURVE =
      Table.<CurvePoint>of("curve.csv")
          .ints("cameras", "cameras", "those that add most first", CurvePoint::cameras)
          .plain("price", "as asked", "of these", CurvePoint::price)
          .doubles("share", SHARE, "met by them", CurvePoint::share)
          .doubles("bound", SHARE, "candidates at the price meet no more", CurvePoint::bound);

  private PlanTables() {}
}
