package org.hificamsim.profiling.fit;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.OptionalDouble;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.hifi.model.PublishedModels;
import org.hificamsim.hifi.optics.Optics;
import org.hificamsim.profiling.measure.Measurement;

/**
 * Writes every combination of f and g as a model file that {@code run --detection} takes: {@code
 * <detector>-<f>.json} with the line on f's own predictions, {@code <detector>-<f>-gt.json} with
 * the line on measured PIP.
 *
 * @param folder where the files go
 * @param prefix of the models' names, before a colon
 */
public record ModelFolder(Path folder, String prefix) {
  /** Writes all models; returns how many. */
  public int write(FitResult result) {
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    int written = 0;
    for (String detector : result.detectors()) {
      for (FeatureResult f : result.features()) {
        write(result, detector, f, f.name(), "");
        write(result, detector, f, FitResult.GROUND_TRUTH, "-gt");
        written += 2;
      }
    }
    return written;
  }

  private void write(FitResult result, String detector, FeatureResult f, String on, String suffix) {
    String name = detector + "-" + f.name() + suffix;
    LineFit fit = result.line(detector, on);
    DetectorLine line = fit.line();
    double longest =
        result.measurements().stream().mapToDouble(Measurement::focalLength).max().orElseThrow();
    HiFiDetection model =
        new HiFiDetection(
            prefix + ":" + name,
            f.fit().f(),
            line,
            new Optics(result.camera().sensorWidth(), longest),
            PublishedModels.published().threshold(line),
            fit.rmse() > 0 ? OptionalDouble.of(fit.rmse()) : OptionalDouble.empty(),
            provenance(result, f, fit, on));
    ModelFiles.write(model, folder.resolve(name + ".json"));
  }

  private Provenance provenance(FitResult result, FeatureResult f, LineFit line, String on) {
    return Provenance.UNKNOWN
        .with("source", "profile fit, " + result.measurements().size() + " photos")
        .with("equation", f.fit().equation())
        .with(
            "f",
            String.format(
                Locale.ROOT,
                "R2 %.3f, %d-fold %.3f +- %.3f, of -log10(PIP)",
                f.scores().r2(),
                f.validation().folds().length,
                f.validation().mean(),
                f.validation().deviation()))
        .with(
            "g",
            String.format(
                Locale.ROOT,
                "on %s PIP: R2 %.3f, RMSE %.4f",
                on.equals(FitResult.GROUND_TRUTH) ? "measured" : "predicted",
                line.r2(),
                line.rmse()));
  }
}
