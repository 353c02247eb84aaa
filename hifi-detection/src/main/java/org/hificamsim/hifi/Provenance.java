package org.hificamsim.hifi;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * Where a model's numbers come from: named remarks, such as {@code source} and {@code equation}.
 *
 * @param remarks texts by name, in the order in which they are written
 */
public record Provenance(Map<String, String> remarks) {
  /** Nothing is known. */
  public static final Provenance UNKNOWN = new Provenance(Map.of());

  public Provenance {
    remarks = Collections.unmodifiableMap(new LinkedHashMap<>(remarks));
  }

  /** The same with one more remark. */
  public Provenance with(String name, String remark) {
    Map<String, String> more = new LinkedHashMap<>(remarks);
    more.put(name, remark);
    return new Provenance(more);
  }

  /** The equation, table or data set, or an empty text. */
  public String source() {
    return remarks.getOrDefault("source", "");
  }
}
