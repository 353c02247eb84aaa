package org.hificamsim.tracks;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.stream.Collectors;
import org.hificamsim.core.Texts;
import org.hificamsim.tracks.format.Unit;

/**
 * Finds signs that positions or times of a recording were read in another unit than they have.
 *
 * @param unit in which positions were read
 */
record MotionSigns(MotionMeasures motion, Unit unit) {
  /** The speed of those that move, metres per second, below which no recording of people is. */
  private static final double CRAWLING = 0.01;

  /** A degree is about 100 km, so that people move less than this in degrees a second. */
  private static final double DEGREES_PER_SECOND = 1e-3;

  /** The median speed of people read 25 times too slowly, metres per second. */
  private static final double SLOW = 0.1;

  private static final double FAST = 60;
  private static final double TOO_FAST = 100;

  private static final double MAX_EXTENT = 1e5; // metres
  private static final int MIN_MOVES = 10;
  private static final int MIN_SINGLE_SAMPLES = 3;

  void addTo(Plausibility signs) {
    double median = motion.quantile(0.5);
    if (unit == Unit.M && motion.quantile(0.9) < DEGREES_PER_SECOND && motion.isWithinDegrees()) {
      signs.fault(
          Texts.format(
              "nobody moves faster than %.2g m/s, and all positions are within 180 and 90: they"
                  + " are probably degrees",
              motion.quantile(0.9)),
          setting("unit", "deg"));
    } else if (motion.quantile(0.9) < CRAWLING) {
      signs.fault(speedsUpTo(motion.quantile(0.9), "nine tenths"), slowCauses());
    } else if (median < SLOW) {
      signs.doubt(speedsUpTo(median, "half") + ", expected " + slowCauses() + " unless it is so");
    } else if (median > TOO_FAST && unit != Unit.DEG) {
      signs.fault(speedsFrom(median), fastCauses(median));
    } else if (median > FAST) {
      signs.doubt(speedsFrom(median) + ", expected " + fastCauses(median) + " unless it is so");
    }
    addPlaceSigns(signs);
  }

  private static String speedsUpTo(double speed, String share) {
    return Texts.format(
        "%s of those who move are slower than %.2g m/s: positions or times are probably in another"
            + " unit",
        share, speed);
  }

  private static String speedsFrom(double speed) {
    return Texts.format(
        "half of those who move are faster than %.0f m/s: positions or times are probably in"
            + " another unit",
        speed);
  }

  private String slowCauses() {
    String times =
        "%s and %s if times are frames"
            .formatted(setting("columns", "frame=..."), setting("rate", "R"));
    return switch (unit) {
      case CM, MM -> setting("unit", "m") + ", or " + times;
      case M -> setting("unit", "deg") + " if positions are degrees, or " + times;
      default -> times;
    };
  }

  private String fastCauses(double median) {
    String times = "another %s".formatted(setting("rate"));
    return switch (unit) {
      case M -> setting("unit", median > 10 * TOO_FAST ? "mm" : "cm") + ", or " + times;
      case PX -> "another %s, or %s".formatted(setting("homography"), times);
      default -> times;
    };
  }

  private void addPlaceSigns(Plausibility signs) {
    if (motion.moves() == 0 && motion.targets() >= MIN_SINGLE_SAMPLES) {
      signs.fault(
          "no target has two samples: the ids are probably those of rows",
          setting("columns", "id=...") + " with what names a target");
    }
    if (motion.moves() >= MIN_MOVES && !motion.flags().isEmpty()) {
      signs.fault(
          "x and y have hardly any values but %s: they are probably flags, and no positions"
              .formatted(
                  motion.flags().stream().map(String::valueOf).collect(Collectors.joining(", "))),
          "other " + setting("columns"));
    } else if (motion.moves() >= MIN_MOVES && motion.speeds().length == 0) {
      signs.doubt("nobody moves: x and y may not be the positions, see " + setting("columns"));
    }
    if (motion.extent() > MAX_EXTENT) {
      signs.doubt(
          Texts.format(
              "positions are up to %.0f km apart: some are probably outliers, or in another %s",
              motion.extent() / 1000, setting("unit")));
    }
  }
}
