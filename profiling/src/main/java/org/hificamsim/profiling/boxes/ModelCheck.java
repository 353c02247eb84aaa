package org.hificamsim.profiling.boxes;

import java.util.List;
import org.hificamsim.hifi.boxes.FoundCurve;
import org.hificamsim.profiling.fit.Reliability;

/** A comparison of the model's expectation for measured boxes with the detector's finds. */
public final class ModelCheck {
  private ModelCheck() {}

  /** Returns the chances and outcomes of all boxes. */
  public static Reliability of(FoundCurve model, List<PersonBox> boxes) {
    return new Reliability(
        boxes.stream().mapToDouble(box -> box.chance(model)).toArray(),
        boxes.stream().mapToDouble(PersonBox::found).toArray());
  }
}
