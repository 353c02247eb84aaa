package org.hificamsim.tracks;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.stream.Collectors;
import org.hificamsim.core.Texts;
import org.hificamsim.tracks.format.Unit;

/**
 * Finds signs that positions or times of a recording were read in another unit than they have.
 *
 * @param unit the unit in which positions were read
 */
record MotionSigns(MotionMeasures motion, Unit unit) {
  /** The least speed of moving people in a recording, in metres per second. */
  private static final double CRAWLING = 0.01;

  /** The greatest speed of people in degrees a second, since a degree is about 100 km. */
  private static final double DEGREES_PER_SECOND = 1e-3;

  /** The median speed of people read 25 times too slowly, in metres per second. */
  private static final double SLOW = 0.1;

  private static final double FAST = 60;
  private static final double TOO_FAST = 100;

  /** The extent from which positions are doubtful, in metres. */
  private static final double MAX_EXTENT = 1e5;

  private static final int MIN_MOVES = 10;

  /** The time between samples, in seconds, from which it may really be in milliseconds. */
  private static final double SELDOM = 10;

  /** The least time that is a date, in seconds. */
  private static final double DATES = 1e8;

  private static final double MILLISECONDS_PER_SECOND = 1000;
  private static final String MILLISECONDS_CURE =
      setting("columns", "frame=...") + " and " + setting("rate", "1000");

  /** The side of a square that is too small for a standing target, in metres. */
  private static final double NO_ROOM = 0.1;

  private static final int MIN_SINGLE_SAMPLES = 3;

  void addTo(Plausibility signs) {
    double median = motion.quantile(0.5);
    if (mayBeDegrees() && motion.quantile(0.9) < DEGREES_PER_SECOND) {
      signs.fault(
          Texts.format(
              "nobody moves faster than %.2g m/s, and all positions are within 180 and 90: they"
                  + " are probably degrees%s",
              motion.quantile(0.9), mayBeMilliseconds() ? ", or times milliseconds" : ""),
          setting("unit", "deg") + (mayBeMilliseconds() ? ", or " + MILLISECONDS_CURE : ""));
    } else if (motion.quantile(0.9) < CRAWLING) {
      signs.fault(speedsUpTo(motion.quantile(0.9), "nine tenths"), slowCauses());
    } else if (median < SLOW) {
      signs.doubt(speedsUpTo(median, "half") + ", expected " + slowCauses() + " unless it is so");
    } else if (median > TOO_FAST && unit != Unit.DEG) {
      signs.fault(speedsFrom(median), fastCauses(median));
    } else if (median > FAST) {
      signs.doubt(speedsFrom(median) + ", expected " + fastCauses(median) + " unless it is so");
    }
    addPositionSigns(signs);
  }

  private boolean mayBeDegrees() {
    return unit == Unit.M && motion.isWithinDegrees();
  }

  /** Whether whole numbers of milliseconds in place of seconds explain slow targets. */
  private boolean mayBeMilliseconds() {
    double interval = motion.interval();
    double speed = MILLISECONDS_PER_SECOND * motion.quantile(0.5);
    boolean isWhole = interval == Math.rint(interval) && motion.firstTick() < DATES;
    return interval >= SELDOM && isWhole && speed > SLOW && speed < FAST;
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
        mayBeMilliseconds()
            ? MILLISECONDS_CURE + " if times are milliseconds"
            : "%s and %s if times are frames"
                .formatted(setting("columns", "frame=..."), setting("rate", "R"));
    if (unit == Unit.CM || unit == Unit.MM) {
      return setting("unit", "m") + ", or " + times;
    }
    return mayBeDegrees()
        ? setting("unit", "deg") + " if positions are degrees, or " + times
        : times;
  }

  private String fastCauses(double median) {
    String times = "another %s".formatted(setting("rate"));
    return switch (unit) {
      case M -> setting("unit", median > 10 * TOO_FAST ? "mm" : "cm") + ", or " + times;
      case PX -> "another %s, or %s".formatted(setting("homography"), times);
      default -> times;
    };
  }

  private void addPositionSigns(Plausibility signs) {
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
      addStandingSigns(signs);
    }
    if (motion.extent() > MAX_EXTENT) {
      signs.doubt(
          Texts.format(
              "positions are up to %.0f km apart: some are probably outliers, or in another %s",
              motion.extent() / 1000, setting("unit")));
    }
  }

  private void addStandingSigns(Plausibility signs) {
    double room = motion.extent() * motion.extent() / motion.targets();
    if (mayBeDegrees() && motion.targets() > 1 && room < NO_ROOM * NO_ROOM) {
      signs.fault(
          Texts.format(
              "%s targets stand within %.2g m, and all positions are within 180 and 90: they are"
                  + " probably degrees",
              motion.targets(), motion.extent()),
          setting("unit", "deg"));
    } else {
      signs.doubt(
          "nobody moves: x and y may not be the positions, see %s%s"
              .formatted(
                  setting("columns"),
                  mayBeDegrees() ? ", or are degrees: " + setting("unit", "deg") : ""));
    }
  }
}
