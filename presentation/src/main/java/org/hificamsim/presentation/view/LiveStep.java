package org.hificamsim.presentation.view;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.Move;

/**
 * What one step left in each simulation.
 *
 * @param sides the simulations, 1 or 2
 */
public record LiveStep(List<Side> sides) {
  /**
   * One simulation's part.
   *
   * @param moves cameras that stand or see otherwise since the step that was sent before
   * @param score what the objective makes of the step
   */
  public record Side(Frame frame, List<Move> moves, double score) {}

  /** Which step, from 0. */
  long number() {
    return sides.get(0).frame().step();
  }

  /** This step, with the moves of one that is left out before it. */
  LiveStep after(LiveStep left) {
    List<Side> merged = new ArrayList<>();
    for (int i = 0; i < sides.size(); i++) {
      List<Move> moves = new ArrayList<>(left.sides.get(i).moves());
      moves.addAll(sides.get(i).moves());
      merged.add(new Side(sides.get(i).frame(), moves, sides.get(i).score()));
    }
    return new LiveStep(merged);
  }

  /** The same without the estimates of one simulation: they were another policy's. */
  LiveStep withoutEstimates(int side) {
    List<Side> changed = new ArrayList<>(sides);
    Side whole = sides.get(side);
    changed.set(side, new Side(whole.frame().withoutEstimates(), whole.moves(), whole.score()));
    return new LiveStep(changed);
  }
}
