package org.hificamsim.runs.compare;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.List;
import org.hificamsim.core.InputException;

/**
 * The policy with which each other policy is compared. Fewer comparisons need fewer seeds.
 *
 * @param policy the policy with its options, or {@code all} to compare every policy with every
 *     other
 */
public record ReferencePolicy(String policy) {
  private static final String ALL = "all";

  /**
   * Finds the reference among the policies of a comparison.
   *
   * @param text the name of the policy, or {@code all}; null for the first policy
   * @throws InputException if there is no policy of this name
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
