package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.hifi.detector.DetectorModel;

/**
 * Between which confidences a curve lies with 95% confidence, by a bootstrap that draws whole
 * objects; folds where there is one object.
 *
 * @param pip where
 * @param low lower end
 * @param high upper end
 */
public record CurveBand(double[] pip, double[] low, double[] high) {
  private static final int DRAWS = 200;

  /** Of a detector's g on measured PIP. */
  public static CurveBand of(FitResult result, String detector, double[] pip, long seed) {
    DetectorShape shape =
        DetectorShape.of(result.model(detector, FitResult.GROUND_TRUTH).chosen().shape());
    SplittableRandom random = new SplittableRandom(seed);
    List<DetectorModel> curves = new ArrayList<>();
    for (int draw = 0; draw < DRAWS; draw++) {
      int[] rows = drawn(result.unseen(), random);
      curves.add(
          shape.fit(
              Groups.at(rows, result.measuredPip()),
              Groups.at(rows, result.confidences(detector))));
    }
    return new CurveBand(pip, ends(curves, pip, 2.5), ends(curves, pip, 97.5));
  }

  private static int[] drawn(Groups groups, SplittableRandom random) {
    return IntStream.range(0, groups.count())
        .map(any -> random.nextInt(groups.count()))
        .flatMap(group -> IntStream.of(groups.rows().get(group)))
        .toArray();
  }

  private static double[] ends(List<DetectorModel> curves, double[] pip, double percent) {
    return IntStream.range(0, pip.length)
        .mapToDouble(
            i ->
                StatUtils.percentile(
                    curves.stream().mapToDouble(g -> g.confidence(pip[i])).toArray(), percent))
        .toArray();
  }
}
