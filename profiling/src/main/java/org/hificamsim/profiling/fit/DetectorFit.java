package org.hificamsim.profiling.fit;

import java.util.List;

/**
 * What one detector's confidences say of PIP, measured or predicted by one f.
 *
 * @param shapes every shape of g, the simplest first
 * @param chosen the one that is taken
 * @param scatter about the chosen one
 * @param slope whether confidence rises at all
 */
public record DetectorFit(
    List<ShapeFit> shapes, ShapeFit chosen, ObjectScatter scatter, RisingSlope slope) {
  /** One shape. */
  public ShapeFit shape(String name) {
    return shapes.stream().filter(one -> one.shape().equals(name)).findFirst().orElseThrow();
  }

  /** Whether this is no detector: nobody can be sure that a larger target is detected sooner. */
  public boolean refused() {
    return !slope.sure();
  }
}
