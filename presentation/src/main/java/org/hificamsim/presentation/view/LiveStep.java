package org.hificamsim.presentation.view;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.hificamsim.presentation.replay.Frame;
import org.hificamsim.presentation.replay.Move;

/**
 * The result of one step in each simulation.
 *
 * @param sides the simulations, 1 or 2
 */
public record LiveStep(List<Side> sides) {
  /**
   * The result of a step in one simulation.
   *
   * @param moves the poses of cameras that have changed since the step before
   * @param score the score of the step by the objective
   */
  public record Side(Frame frame, List<Move> moves, double score) {}

  /** The number of the step, from 0. */
  long number() {
    return sides.get(0).frame().step();
  }

  /**
   * Returns this step with the moves of a step before it that is removed. It has one move of each
   * camera, the last one.
   */
  LiveStep withMovesOf(LiveStep removed) {
    List<Side> merged = new ArrayList<>();
    for (int i = 0; i < sides.size(); i++) {
      int side = i;
      Map<Integer, Move> moves = new LinkedHashMap<>();
      Stream.of(removed, this)
          .flatMap(step -> step.sides.get(side).moves().stream())
          .forEach(move -> moves.put(move.camera(), move));
      Side last = sides.get(side);
      merged.add(new Side(last.frame(), List.copyOf(moves.values()), last.score()));
    }
    return new LiveStep(merged);
  }

  /** Returns this step without the estimates in one simulation. */
  LiveStep withoutEstimates(int side) {
    List<Side> changed = new ArrayList<>(sides);
    Side result = sides.get(side);
    changed.set(side, new Side(result.frame().withoutEstimates(), result.moves(), result.score()));
    return new LiveStep(changed);
  }
}
