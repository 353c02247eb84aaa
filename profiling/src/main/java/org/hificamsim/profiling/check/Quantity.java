package org.hificamsim.profiling.check;

import java.util.function.ToDoubleFunction;

/** What of a box is compared. */
enum Quantity {
  /** In pixels. */
  HEIGHT(Size::height),

  /** The share of the picture that the box fills; as a relative error that of its area. */
  PIP(Size::area);

  @SuppressWarnings("ImmutableEnumChecker") // without state
  private final ToDoubleFunction<Size> value;

  Quantity(ToDoubleFunction<Size> value) {
    this.value = value;
  }

  double of(Size size) {
    return value.applyAsDouble(size);
  }
}
