package org.hificamsim.placement.site;

import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Floorplan;

/**
 * Cameras on a site, as documents show them. A search has found them, or they are those that the
 * site has.
 */
public interface CameraPlan {
  /** Returns the cameras, the kept ones first, and what they cover. */
  PlanCover cover();

  /** The meaning of covering a point, by which the cover is measured. */
  CoverageReading reading();

  /** The number of cameras that stay. */
  int keptCameras();

  /** The new cameras, as products to order. */
  List<Product> products();

  /** Returns lines for people that say how good the plan is, beginning with what it meets. */
  List<String> facts();

  /** Returns the site with these cameras, and with its floor plan in the folder of the plan. */
  Scenario scenario();

  /**
   * A camera that can be ordered.
   *
   * @param price the price in the currency of its catalogue
   */
  record Product(String name, double price) {}

  /** The demand that the cameras have to cover. */
  default Demand demand() {
    return cover().demand();
  }

  /** The cameras as elements of a scenario: those that stay, then the new ones. */
  default List<CameraSpec> cameras() {
    return cover().cameras();
  }

  /** The price of all new cameras. */
  default double price() {
    return products().stream().mapToDouble(Product::price).sum();
  }

  /**
   * Returns the first of the facts, which says how many cameras there are, what they cost, and what
   * they meet.
   *
   * @param note a remark on the cameras, which follows their number; may be empty
   * @param price the price of the new ones
   */
  default String claim(String note, String price) {
    return Texts.format(
        "%s%s, price %s: %.2f %% of the demand is met",
        Texts.counted(cameras().size(), "camera"), note, price, 100 * cover().claimedShare());
  }

  /** The height at which a camera hangs, in metres; NaN if the site has none. */
  default double height(CameraSpec camera) {
    return camera.z().orElse(demand().site().mountHeight().orElse(Double.NaN));
  }

  /** Returns a site with its floor plan in the folder of its scenario. */
  static Scenario withFloorplanInFolder(Scenario site) {
    return site.floorplan()
        .map(floor -> site.withFloorplan(new Floorplan(fileName(floor), floor.area())))
        .orElse(site);
  }

  private static String fileName(Floorplan floor) {
    return Path.of(floor.file()).getFileName().toString();
  }
}
