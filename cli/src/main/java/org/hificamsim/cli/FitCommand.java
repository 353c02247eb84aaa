package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Texts;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.fit.DetectorShape;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FitSettings;
import org.hificamsim.profiling.fit.FitSettings.SupportVectorSettings;
import org.hificamsim.profiling.fit.FitSettings.SymbolicSettings;
import org.hificamsim.profiling.fit.FittedModel;
import org.hificamsim.profiling.fit.Fitting;
import org.hificamsim.profiling.fit.Recommendation;
import org.hificamsim.profiling.fit.ShapeFit;
import org.hificamsim.profiling.measure.AlarmThreshold;
import org.hificamsim.profiling.measure.Measurement;
import org.hificamsim.profiling.measure.MeasurementsFile;
import org.hificamsim.profiling.measure.PipReading;
import org.hificamsim.profiling.report.FitReport;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.output.ResultFolder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim profile fit}: makes models and a report from measurements. */
@Command(
    name = "fit",
    description =
        "Fits detection models to measurements.csv; writes models/*.json and report.html.")
final class FitCommand implements Callable<Integer> {
  private static final String BEST = "best";

  /** The cost of each node of a formula. */
  private static final double PARSIMONY = 0.001;

  /** The least width of the column with the names of models, in characters. */
  private static final int MIN_WIDTH = 16;

  @Parameters(paramLabel = "DIR", description = "The folder of a measured data set.")
  private Path folder;

  @Option(names = "--confidences", paramLabel = "FILE")
  private Path confidences;

  @Option(names = "--name", paramLabel = "NAME")
  private String name;

  @Option(names = "--folds", paramLabel = "K")
  private int folds;

  @Option(names = "--population", paramLabel = "N")
  private int population;

  @Option(names = "--generations", paramLabel = "N")
  private int generations;

  @Option(names = "--restarts", paramLabel = "N")
  private int restarts;

  @Option(names = "--g", paramLabel = "SHAPE")
  private String shape;

  @Mixin private ThreadsOption threads;

  @Spec private CommandSpec spec;

  @Mixin private final SettingOptions seed = SettingOptions.of(Setting.SEED);

  @Override
  public Integer call() throws IOException {
    FitSettings settings = settings();
    int count = threads.count();
    Destination.claim(spec, folder, List.of(FitReport.REPORT));
    PhotoCamera camera = PhotoCamera.of(folder);
    List<Measurement> measurements = measurements(camera);
    FitResult result = new Fitting(settings).fit(camera, measurements, count);
    print(result, write(result));
    return 0;
  }

  private int write(FitResult result) throws IOException {
    PipReading pip = confidences == null ? PipReading.ofDataset(folder) : PipReading.RECTANGLE;
    return FitReport.write(folder, result, pip, ResultFolder.name(folder), name);
  }

  private List<Measurement> measurements(PhotoCamera camera) {
    return confidences == null
        ? MeasurementsFile.read(folder.resolve(MeasurementsFile.NAME))
        : MeasurementsFile.readUserTable(confidences, camera);
  }

  private void print(FitResult result, int models) {
    PrintWriter out = spec.commandLine().getOut();
    List<FittedModel> fittedModels = FittedModel.all(result);
    PrintWriter err = spec.commandLine().getErr();
    fittedModels.stream()
        .filter(model -> model.fit().rejected())
        .forEach(model -> err.println("warning: " + model.refusal()));
    int width = fittedModels.stream().mapToInt(model -> model.name().length()).max().orElse(0);
    String column = "%-" + Math.max(MIN_WIDTH, width) + "s";
    out.printf(column + " %7s %7s %8s  g%n", "model", "R2", "unseen", "RMSE");
    fittedModels.stream()
        .filter(model -> !model.fit().rejected() && !model.onMeasuredPip())
        .forEach(model -> out.println(row(column, model)));
    Recommendation.all(result).forEach(recommendation -> out.println(recommendation.sentence()));
    out.println(Recommendation.lens(result));
    out.printf("%s in %s%n", Texts.counted(models, "model"), folder.resolve(FittedModel.FOLDER));
    out.printf("report: %s%n", folder.resolve("report.html"));
    if (models == 0) {
      throw InputException.of(
          "%s: no confidence surely rises with PIP, expected one at least",
          folder.resolve(MeasurementsFile.NAME));
    }
  }

  private static String row(String column, FittedModel model) {
    ShapeFit g = model.fit().chosen();
    return Texts.format(
        column + " %7.3f %7.3f %8.4f  %s",
        model.name(),
        g.scores().r2(),
        g.unseen().r2(),
        g.unseen().rmse(),
        g.shape());
  }

  private Optional<String> shape() {
    return shape.equals(BEST) ? Optional.empty() : Optional.of(DetectorShape.of(shape).name());
  }

  private FitSettings settings() {
    if (!name.matches("[A-Za-z0-9][A-Za-z0-9._-]{0,39}")) {
      throw InputException.of(
          "--name is '%s', expected 1 to 40 letters, digits, or any of . _ -", name);
    }
    Numbers.inRange("--folds", folds, 2, 100);
    Numbers.inRange("--population", population, 50, 1_000_000);
    Numbers.inRange("--generations", generations, 1, 100_000);
    Numbers.inRange("--restarts", restarts, 1, 1000);
    return new FitSettings(
        folds,
        seed.settings().seed(),
        new SymbolicSettings(population, generations, PARSIMONY, seed.settings().seed(), restarts),
        SupportVectorSettings.THESIS,
        shape(),
        AlarmThreshold.read(folder));
  }
}
