package org.hificamsim.runs.compare;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.List;
import org.hificamsim.core.InputException;

/**
 * The policy that all others are compared with, one by one. Fewer comparisons need fewer seeds.
 *
 * @param policy with its options, or {@code all}: every policy is compared with every other
 */
public record ReferencePolicy(String policy) {
  private static final String ALL = "all";

  /**
   * Finds the reference among the policies of a comparison.
   *
   * @param text null for the first policy
   * @throws InputException if it names none of them
   */
  public static ReferencePolicy of(String text, List<String> policies) {
    if (text == null) {
      return new ReferencePolicy(policies.get(0));
    }
    if (!text.equals(ALL) && !policies.contains(text)) {
      throw InputException.of(
          "%s is '%s', expected one of the policies that are compared (%s) or %s",
          setting("reference"), text, String.join(", ", policies), ALL);
    }
    return new ReferencePolicy(text);
  }

  boolean isAll() {
    return policy.equals(ALL);
  }
}
