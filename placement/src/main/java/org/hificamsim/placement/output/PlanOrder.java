package org.hificamsim.placement.output;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.hificamsim.placement.site.CameraKind;
import org.hificamsim.placement.site.SitePlan;

/** The products to order for a plan: the kinds of its new cameras. */
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
    Map<String, List<CameraKind>> kinds =
        plan.newKinds().stream()
            .collect(Collectors.groupingBy(CameraKind::name, TreeMap::new, Collectors.toList()));
    List<Product> products = new ArrayList<>();
    kinds.forEach(
        (name, same) ->
            products.add(new Product(name, same.size(), same.get(0).price(), currency)));
    return products;
  }
}
