package org.hificamsim.placement.site;

import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Floorplan;

/** Cameras on a site as documents show them: found by a search, or as they are. */
public interface CameraPlan {
  /** The cameras, those that stay first, and what they cover. */
  PlanCover cover();

  /** How views count. */
  CoverageReading reading();

  /** The number of cameras that stay. */
  int keptCameras();

  /** The new cameras as they are ordered. */
  List<Product> products();

  /** The quality of the plan in lines for people, the shares that are met first. */
  List<String> facts();

  /** The site with these cameras, and with its floor plan in the folder of the plan. */
  Scenario scenario();

  /**
   * A camera as it is ordered.
   *
   * @param price in the currency of its catalogue
   */
  record Product(String name, double price) {}

  /** What the cameras have to cover. */
  default Demand demand() {
    return cover().demand();
  }

  /** The cameras that stay, then the new ones, as elements of a scenario. */
  default List<CameraSpec> cameras() {
    return cover().cameras();
  }

  /** The price of all new cameras. */
  default double price() {
    return products().stream().mapToDouble(Product::price).sum();
  }

  /**
   * The first of the facts: how many cameras there are, what they cost, and what they meet.
   *
   * @param note on the cameras, after their number
   * @param price of the new ones
   */
  default String claim(String note, String price) {
    return Texts.format(
        "%s%s, price %s: %.2f %% of the demand is met",
        Texts.counted(cameras().size(), "camera"), note, price, 100 * cover().claimedShare());
  }

  /** The height at which a camera hangs, metres; NaN if the site has none. */
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
