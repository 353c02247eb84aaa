package org.hificamsim.hifi;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Named remarks on where a model's numbers come from, such as {@code source} and {@code equation}.
 *
 * @param remarks texts by name, in the order in which they are written
 */
public record Provenance(Map<String, String> remarks) {
  /** The provenance of a model without remarks. */
  public static final Provenance UNKNOWN = new Provenance(Map.of());

  public Provenance {
    remarks = Collections.unmodifiableMap(new LinkedHashMap<>(remarks));
  }

  /** Returns a copy with one more remark. */
  public Provenance with(String name, String remark) {
    Map<String, String> more = new LinkedHashMap<>(remarks);
    more.put(name, remark);
    return new Provenance(more);
  }

  /** Returns the equation, table or data set that the numbers come from; empty if unknown. */
  public String source() {
    return remarks.getOrDefault("source", "");
  }
}
