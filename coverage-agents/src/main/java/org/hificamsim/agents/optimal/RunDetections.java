package org.hificamsim.agents.optimal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.solver.BitMatrix;
import org.hificamsim.solver.configuration.CoverageProblem;
import org.hificamsim.solver.way.TravelTimes;
import org.hificamsim.solver.way.WayProblem;

/**
 * Collects what each camera would detect in each of its views over a whole run.
 *
 * <p>A moment is a target that is present in a step and counts for the objective. The moments of a
 * step have consecutive numbers. Each view of a camera has the set of moments that it detects.
 */
final class RunDetections {
  /** The moments that are detected, by camera and view. */
  private final List<BitSet[]> detectedMoments = new ArrayList<>();

  /** The steps in which each camera is online. */
  private final List<BitSet> online = new ArrayList<>();

  /** The moment of each target in the step that is added. */
  private int[] momentByTarget = {};

  private boolean[] coverable = {};
  private long[] masks = {};

  /** The end of each step's moments, exclusive. */
  private int[] ends = new int[16];

  private int steps;
  private int moments;
  private Objective objective = Objective.kMin();

  /** Adds a step with the network as it is now. */
  void add(OracleView network) {
    objective = network.objective();
    for (int camera = detectedMoments.size(); camera < network.cameras(); camera++) {
      BitSet[] views = new BitSet[network.views(camera)];
      Arrays.setAll(views, view -> new BitSet());
      detectedMoments.add(views);
      online.add(new BitSet());
    }
    numberMoments(network);
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        online.get(camera).set(steps);
        addDetections(network, camera);
      }
    }
    ends = steps == ends.length ? Arrays.copyOf(ends, 2 * steps) : ends;
    ends[steps++] = moments;
  }

  /** Gives each target that counts in this step the number of its moment. */
  private void numberMoments(OracleView network) {
    if (momentByTarget.length < network.targets()) {
      momentByTarget = new int[network.targets()];
      coverable = new boolean[network.targets()];
    }
    boolean allCount = !objective.countsCoverableOnly();
    if (!allCount) {
      network.markCoverable(coverable);
    }
    for (int target = 0; target < network.targets(); target++) {
      momentByTarget[target] = moments;
      moments += network.present(target) && (allCount || coverable[target]) ? 1 : 0;
    }
  }

  /** Adds what a camera detects in each of its views. Every detected target counts. */
  private void addDetections(OracleView network, int camera) {
    BitSet[] views = detectedMoments.get(camera);
    int words = BitMatrix.wordsFor(network.targets());
    masks = masks.length < views.length * words ? new long[views.length * words] : masks;
    network.detections(camera, masks, words);
    for (int i = 0; i < views.length * words; i++) {
      for (long bits = masks[i]; bits != 0; bits &= bits - 1) {
        int target = BitMatrix.firstColumn(i % words, bits);
        views[i / words].set(momentByTarget[target]);
      }
    }
  }

  /** Returns the problem of choosing a view for each camera; its targets are the moments. */
  CoverageProblem problem() {
    int sets = detectedMoments.stream().mapToInt(views -> views.length).sum();
    CoverageProblem problem = new CoverageProblem(detectedMoments.size(), sets, moments);
    problem.clear(moments);
    for (BitSet[] views : detectedMoments) {
      problem.addCamera();
      for (BitSet view : views) {
        problem.addSet(Arrays.copyOf(view.toLongArray(), problem.words()), 0);
      }
    }
    return problem;
  }

  /** Returns the problem of planning each camera's way between its views. */
  WayProblem ways(List<TravelTimes> times) {
    return new WayProblem(objective, ends(), times, online, detectedMoments);
  }

  /** Returns the steps in which each camera is online; callers must not change them. */
  List<BitSet> online() {
    return online;
  }

  /** Returns the end of each step's moments, exclusive. */
  int[] ends() {
    return Arrays.copyOf(ends, steps);
  }

  /** The objective by which the steps are scored. */
  Objective objective() {
    return objective;
  }
}
