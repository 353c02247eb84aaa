package org.hificamsim.profiling.check;

import java.util.function.ToDoubleFunction;
import org.hificamsim.profiling.check.Calibration.Size;

/** A quantity of a box that is compared. */
@SuppressWarnings("ImmutableEnumChecker") // the lambdas have no state
enum BoxQuantity {
  /** The height in pixels. */
  HEIGHT(Size::height),
  /** The share of the picture that the box fills; its relative error is that of the area. */
  PIP(Size::area);

  private final ToDoubleFunction<Size> value;

  BoxQuantity(ToDoubleFunction<Size> value) {
    this.value = value;
  }

  double of(Size size) {
    return value.applyAsDouble(size);
  }
}
