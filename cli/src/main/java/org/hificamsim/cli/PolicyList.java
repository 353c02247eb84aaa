package org.hificamsim.cli;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;

/**
 * The list {@code P,Q:key=value,key=value,R} of policies with options: a part between commas starts
 * a new policy unless it is a {@code key=value} or a number, which continues the one before it.
 */
final class PolicyList {
  private PolicyList() {}

  /**
   * The policies, each checked with its options.
   *
   * @throws org.hificamsim.core.InputException when one is unknown or an option is wrong
   */
  static List<String> split(String list, Registry<ZoomPolicy> policies) {
    List<String> specs = new ArrayList<>();
    for (String part : list.split(",", -1)) {
      String text = part.strip();
      boolean continues =
          !specs.isEmpty() && !policies.knows(text) && text.matches("[^:]*=.*|\\d+");
      if (continues) {
        specs.set(specs.size() - 1, specs.get(specs.size() - 1) + "," + text);
      } else {
        specs.add(text);
      }
    }
    specs.forEach(policies::create);
    return specs;
  }
}
