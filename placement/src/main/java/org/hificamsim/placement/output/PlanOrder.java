package org.hificamsim.placement.output;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.hificamsim.placement.site.CameraPlan;

/** Finds which products have to be ordered for a plan. */
final class PlanOrder {
  private PlanOrder() {}

  /**
   * A product of the catalogue and the quantity to order.
   *
   * @param price the price of a single one
   */
  record Product(String name, int quantity, double price, String currency) {
    /** The price of all. */
    double total() {
      return quantity * price;
    }
  }

  /** Returns the products to order, sorted by name. */
  static List<Product> of(CameraPlan plan, String currency) {
    Map<CameraPlan.Product, Long> quantities =
        plan.products().stream()
            .collect(
                Collectors.groupingBy(
                    product -> product,
                    () ->
                        new TreeMap<>(
                            Comparator.comparing(CameraPlan.Product::name)
                                .thenComparing(CameraPlan.Product::price)),
                    Collectors.counting()));
    List<Product> products = new ArrayList<>();
    quantities.forEach(
        (product, quantity) ->
            products.add(
                new Product(product.name(), quantity.intValue(), product.price(), currency)));
    return products;
  }
}
