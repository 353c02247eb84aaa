package org.hificamsim.tracks.format;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.Texts;

/**
 * Compares how far targets move with the speeds that SUMO says they have: degrees of longitude and
 * latitude, read as metres, are a hundred thousand times too short.
 */
final class FcdSpeeds {
  /**
   * The factor by which ways may be shorter than speeds say; beyond it, positions are not in
   * metres.
   */
  private static final double MAX_RATIO = 1000;

  /** The shortest expected way that is compared, in metres. */
  private static final double MIN_EXPECTED = 1;

  private final Map<String, TrackSample> last = new HashMap<>();
  private double moved;
  private double expected;

  /** Adds a sample with the speed in the file, in metres per second; NaN if it has none. */
  void add(TrackSample sample, double speed) {
    TrackSample before = last.put(sample.target(), sample);
    if (before != null && speed > 0 && sample.tick() > before.tick()) {
      moved += Math.hypot(sample.x() - before.x(), sample.y() - before.y());
      expected += speed * (sample.tick() - before.tick());
    }
  }

  /** The sign of degrees; empty if there is none. */
  Optional<Doubt> sign() {
    return expected > MIN_EXPECTED && moved * MAX_RATIO < expected
        ? Optional.of(
            new Doubt(
                Texts.format(
                    "targets move %.3g m in all, but %.0f m by their speeds: positions are degrees",
                    moved, expected),
                setting("unit", "deg")))
        : Optional.empty();
  }
}
