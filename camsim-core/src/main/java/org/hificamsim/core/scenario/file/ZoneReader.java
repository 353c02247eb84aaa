package org.hificamsim.core.scenario.file;

import java.util.HashSet;
import java.util.Set;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.core.scenario.xml.XmlElement;

/** Reads the zones of a file, which have unique names and lie in the field. */
public final class ZoneReader {
  private final Field field;
  private final Set<String> names = new HashSet<>();

  /** Prepares to read the zones of a field. */
  public ZoneReader(Field field) {
    this.field = field;
  }

  /** Reads one zone. */
  public Zone zone(XmlElement xml) {
    Zone zone = Attributes.read(xml, Zone.ELEMENT);
    if (!names.add(zone.name())) {
      throw xml.invalid("name", "a name that no other zone has");
    }
    if (!zone.points().stream().allMatch(point -> field.contains(point.x(), point.y()))) {
      throw xml.invalid(
          "points",
          "points inside the field, %s to %s and %s to %s"
              .formatted(field.minX(), field.maxX(), field.minY(), field.maxY()));
    }
    return zone;
  }
}
