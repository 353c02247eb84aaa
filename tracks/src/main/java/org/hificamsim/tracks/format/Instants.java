package org.hificamsim.tracks.format;

import java.time.OffsetDateTime;

/** Points in time as ISO 8601 writes them. */
final class Instants {
  private Instants() {}

  /**
   * Seconds since 1970.
   *
   * @throws java.time.DateTimeException when it is no such time with its zone
   */
  static double seconds(String written) {
    OffsetDateTime time = OffsetDateTime.parse(written);
    return time.toEpochSecond() + time.getNano() / 1e9;
  }
}
