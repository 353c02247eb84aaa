package org.hificamsim.placement.output;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.placement.site.SitePlan;

/** What has to be ordered for a plan: its new cameras, by product. */
final class PlanOrder {
  private PlanOrder() {}

  /**
   * A product of the catalogue.
   *
   * @param price of one
   */
  record Product(String name, int quantity, double price, String currency) {
    /** The price of all. */
    double total() {
      return quantity * price;
    }
  }

  /** The products to order, by name. */
  static List<Product> of(SitePlan plan, String currency) {
    Map<String, List<CameraSpec>> cameras =
        plan.cameras().stream()
            .skip(plan.problem().kept().size())
            .collect(Collectors.groupingBy(PlanOrder::product, TreeMap::new, Collectors.toList()));
    List<Product> products = new ArrayList<>();
    cameras.forEach(
        (name, same) ->
            products.add(new Product(name, same.size(), same.get(0).price(), currency)));
    return products;
  }

  /** The product, of which a lens that zooms is set to one of its angles of view. */
  static String product(CameraSpec camera) {
    return camera.optics().map(OpticsSpec::name).orElse("own").replaceFirst(" at .* degrees$", "");
  }
}
