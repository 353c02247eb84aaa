package org.hificamsim.reproduction.sensitivity;

import java.util.List;

/**
 * A parameter with the values that are tried, rising.
 *
 * @param parameter name in files
 * @param meaning for people
 */
record ParameterSweep(String parameter, String meaning, List<Variant> variants) {
  /** The policies that the parameter can change. */
  List<String> policies() {
    return List.copyOf(variants.get(0).policies().keySet());
  }
}
