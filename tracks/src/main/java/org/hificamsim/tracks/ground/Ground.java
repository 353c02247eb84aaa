package org.hificamsim.tracks.ground;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.tracks.format.TrackSample;
import org.hificamsim.tracks.format.Unit;

/** Converts samples to metres on the ground, x to the east and y to the north. */
public interface Ground {
  /** Returns a sample in metres. */
  TrackSample onGround(TrackSample sample);

  /**
   * Returns the conversion of a unit.
   *
   * @param homography the homography from pictures to the ground; empty if there is none
   * @param projection the projection of degrees; its origin is the first sample if it has none
   * @throws InputException if there are pixels without a homography, or a homography without pixels
   */
  static Ground of(Unit unit, Optional<Homography> homography, LocalProjection projection) {
    if (homography.isPresent() != (unit == Unit.PX)) {
      throw unit == Unit.PX
          ? InputException.of(
              "positions are pixels, expected %s, which converts them to metres",
              setting("homography", "FILE"))
          : InputException.of(
              "%s is for pixels, expected %s as well",
              setting("homography"), setting("unit", "px"));
    }
    return switch (unit) {
      case PX -> homography.get();
      case DEG -> projection;
      default -> sample -> scaled(sample, unit.metres());
    };
  }

  private static TrackSample scaled(TrackSample sample, double metres) {
    return metres == 1
        ? sample
        : sample.at(
            sample.x() * metres,
            sample.y() * metres,
            sample.width() * metres,
            sample.height() * metres);
  }
}
