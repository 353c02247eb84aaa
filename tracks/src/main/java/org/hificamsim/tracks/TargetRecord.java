package org.hificamsim.tracks;

import java.util.Optional;
import org.hificamsim.core.scenario.Extent;
import org.hificamsim.tracks.format.Sample;

/** What is kept of a target while its file is read. */
final class TargetRecord {
  private final int number;
  private final String name;
  private double tick = Double.NEGATIVE_INFINITY;
  private double x;
  private double y;
  private double widths;
  private double heights;
  private int sized;

  TargetRecord(int number, String name) {
    this.number = number;
    this.name = name;
  }

  /** From 0, in the order in which the targets appear in the file. */
  int number() {
    return number;
  }

  /** As the file says it. */
  String name() {
    return name;
  }

  /** When it was seen last; minus infinity before that. */
  double tick() {
    return tick;
  }

  /** Whether it was last seen at this very place. */
  boolean isAt(double itsX, double itsY) {
    return x == itsX && y == itsY;
  }

  /** Takes its latest sample. */
  void seen(Sample sample) {
    tick = sample.tick();
    x = sample.x();
    y = sample.y();
    if (isLength(sample.width()) && isLength(sample.height())) {
      widths += sample.width();
      heights += sample.height();
      sized++;
    }
  }

  private static boolean isLength(double metres) {
    return metres > 0 && metres <= 1e9;
  }

  /** The mean of its boxes; empty where the file has none. */
  Optional<Extent> extent() {
    return sized == 0
        ? Optional.empty()
        : Optional.of(new Extent(rounded(widths / sized), rounded(heights / sized)));
  }

  private static double rounded(double metres) {
    return Math.max(1e-3, Math.rint(metres * 1000) / 1000);
  }
}
