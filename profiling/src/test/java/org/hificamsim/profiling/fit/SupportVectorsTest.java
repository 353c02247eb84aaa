package org.hificamsim.profiling.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.feature.SvrRbfAbstraction;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.hifi.optics.Optics;
import org.hificamsim.profiling.fit.FitSettings.SupportVectorSettings;
import org.hificamsim.profiling.measure.Measurement;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import smile.regression.KernelMachine;

class SupportVectorsTest {
  private static final SupportVectorSettings TIGHT = new SupportVectorSettings(0.1, 1, 1e-6);

  @TempDir Path folder;

  /** A row of the reference file: the data and LIBSVM's predictions. */
  private record Golden(Measurement row, double linear, double rbf) {}

  @Test
  void linearMachineAgreesWithLibsvm() throws IOException {
    List<Golden> golden = golden();
    FittedFeature fit = SupportVectors.linear(TIGHT).fit(rows(golden));
    golden.forEach(g -> assertEquals(g.linear(), fit.response(g.row()), 2e-4));
  }

  @Test
  void rbfMachineAgreesWithLibsvm() throws IOException {
    List<Golden> golden = golden();
    FittedFeature fit = SupportVectors.rbf(TIGHT).fit(rows(golden));
    golden.forEach(g -> assertEquals(g.rbf(), fit.response(g.row()), 2e-4));
  }

  @Test
  void modelFilePredictsTheSameAsSmile() throws IOException {
    List<Measurement> rows = rows(golden());
    KernelMachine<double[]> machine = SupportVectors.rbfMachine(rows, SupportVectorSettings.THESIS);
    double[][] scaled = SupportVectors.scaled(rows);
    HiFiDetection model =
        new HiFiDetection(
            "m",
            SupportVectors.abstraction(rows, machine),
            new DetectorLine(0.5, 0.02),
            new Optics(0.0224, 0.085),
            0.05,
            Optional.empty(),
            Optional.empty(),
            Provenance.UNKNOWN);
    ModelFiles.write(model, folder.resolve("m.json"));
    HiFiDetection written = (HiFiDetection) ModelFiles.read(folder.resolve("m.json"));
    SvrRbfAbstraction read = (SvrRbfAbstraction) written.f();
    for (int i = 0; i < scaled.length; i++) {
      Measurement o = rows.get(i);
      assertEquals(
          machine.predict(scaled[i]),
          read.negativeLogPip(o.size(), o.distance(), o.focalLength()),
          1e-12);
    }
  }

  @Test
  void linearMachineRecoversALine() {
    List<Measurement> data = Synthetic.of((q, d, z) -> -2 * q + 0.2 * d + 3, 0.05, 5);
    LinearAbstraction f =
        (LinearAbstraction) SupportVectors.linear(SupportVectorSettings.THESIS).fit(data).f();
    assertEquals(-2, f.q(), 0.1);
    assertEquals(0.2, f.d(), 0.01);
    assertEquals(3, f.intercept(), 0.1);
  }

  @Test
  void rbfMachineFitsACurve() {
    List<Measurement> data =
        Synthetic.of((q, d, z) -> 3 - 2 * Math.log10(z * q / d / 0.02), 0.05, 6);
    double line = r2(FeatureRegression.linear(), data);
    double rbf = r2(SupportVectors.rbf(SupportVectorSettings.THESIS), data);
    assertTrue(rbf > 0.97, "rbf " + rbf);
    assertTrue(rbf > line + 0.03, "rbf " + rbf + ", line " + line);
  }

  private static double r2(FeatureRegression regression, List<Measurement> data) {
    Groups folds = Groups.folds(data.size(), 5, 0);
    return FeatureResult.all(List.of(regression), data, folds, 1).get(0).validation().mean();
  }

  private static List<Measurement> rows(List<Golden> golden) {
    return golden.stream().map(Golden::row).toList();
  }

  private static List<Golden> golden() throws IOException {
    try (InputStream in = SupportVectorsTest.class.getResourceAsStream("svr-reference.csv")) {
      List<Golden> rows = new ArrayList<>();
      new String(in.readAllBytes(), StandardCharsets.UTF_8)
          .lines()
          .skip(1)
          .forEach(
              line -> {
                String[] cells = line.split(",");
                double[] v = new double[cells.length];
                for (int i = 0; i < v.length; i++) {
                  v[i] = Double.parseDouble(cells[i]);
                }
                double pip = StrictMath.pow(10, -v[3]);
                rows.add(new Golden(Synthetic.photo(v[0], v[1], v[2], pip), v[4], v[5]));
              });
      assertEquals(240, rows.size());
      return rows;
    }
  }
}
