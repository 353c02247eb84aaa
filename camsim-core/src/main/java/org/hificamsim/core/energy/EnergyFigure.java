package org.hificamsim.core.energy;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/** A use of energy in a camera, in the order of profiles. */
public enum EnergyFigure {
  /** Watts while the camera is awake. */
  IDLE("W"),
  /** Watts while its duty cycle lets it sleep. */
  SLEEP("W"),
  /** Joules for each step in which it sees, which is one frame. */
  SENSE("J"),
  /** Joules for each pixel of such a frame, whose height is three quarters of its width. */
  PIXEL("J"),
  /** Joules for each detection. */
  DETECTION("J"),
  /** Joules for each bit sent. */
  SEND("J"),
  /** Joules for each bit received. */
  RECEIVE("J"),
  /** Joules for each degree of pan. */
  PAN("J"),
  /** Joules for each zoom level passed. */
  ZOOM("J");

  private final String unit;

  EnergyFigure(String unit) {
    this.unit = unit;
  }

  /** The key in profiles. */
  String key() {
    return name().toLowerCase(Locale.ROOT);
  }

  double parse(String text) {
    return unit.equals("W") ? Quantity.watts(key(), text) : Quantity.joules(key(), text);
  }

  String text(double value) {
    return key() + "=" + value + unit;
  }

  static String keys() {
    return Arrays.stream(values()).map(EnergyFigure::key).collect(Collectors.joining(", "));
  }
}
