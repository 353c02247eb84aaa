package org.hificamsim.presentation.view;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
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

  /** This step, with the moves of one that is left out before it: the last of each camera. */
  LiveStep after(LiveStep left) {
    List<Side> merged = new ArrayList<>();
    for (int i = 0; i < sides.size(); i++) {
      int side = i;
      Map<Integer, Move> moves = new LinkedHashMap<>();
      Stream.of(left, this)
          .flatMap(step -> step.sides.get(side).moves().stream())
          .forEach(move -> moves.put(move.camera(), move));
      Side own = sides.get(side);
      merged.add(new Side(own.frame(), List.copyOf(moves.values()), own.score()));
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
