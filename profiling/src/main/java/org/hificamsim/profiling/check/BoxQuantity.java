package org.hificamsim.profiling.check;

import java.util.function.ToDoubleFunction;
import org.hificamsim.profiling.check.Calibration.Size;

/** A quantity of a box that is compared. */
@SuppressWarnings("ImmutableEnumChecker") // without state
enum BoxQuantity {
  /** In pixels. */
  HEIGHT(Size::height),
  /** The share of the picture that the box fills; as a relative error that of its area. */
  PIP(Size::area);

  private final ToDoubleFunction<Size> value;

  BoxQuantity(ToDoubleFunction<Size> value) {
    this.value = value;
  }

  double of(Size size) {
    return value.applyAsDouble(size);
  }
}
