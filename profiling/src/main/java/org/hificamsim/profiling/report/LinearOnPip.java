package org.hificamsim.profiling.report;

import java.util.List;
import org.apache.commons.math3.stat.regression.OLSMultipleLinearRegression;
import org.apache.commons.math3.util.MathArrays;
import org.hificamsim.profiling.fit.Observation;

/** Multiple linear regression of PIP itself, for Figure 4.3's left side. */
final class LinearOnPip {
  private LinearOnPip() {}

  static double[] predict(List<Observation> observations) {
    double[][] x = observations.stream().map(Observation::predictors).toArray(double[][]::new);
    double[] y = observations.stream().mapToDouble(Observation::pip).toArray();
    OLSMultipleLinearRegression regression = new OLSMultipleLinearRegression();
    regression.newSampleData(y, x);
    return MathArrays.ebeSubtract(y, regression.estimateResiduals());
  }
}
