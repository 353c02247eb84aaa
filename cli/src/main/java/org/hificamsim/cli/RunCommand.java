package org.hificamsim.cli;

import static picocli.CommandLine.Help.Visibility.NEVER;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Function;
import java.util.function.IntFunction;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.AimingZoomPolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.World;
import org.hificamsim.presentation.replay.FloorPictures;
import org.hificamsim.presentation.replay.ReplayRecorder;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.presentation.report.Report;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.heat.HeatMap;
import org.hificamsim.runs.heat.HeatRecorder;
import org.hificamsim.runs.heat.HeatTable;
import org.hificamsim.runs.output.CrateFile;
import org.hificamsim.runs.output.Detail;
import org.hificamsim.runs.output.InputFiles;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.RunFolder;
import org.hificamsim.runs.output.TableFormat;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim run}: simulates one scenario and writes its coverage. */
@Command(
    name = "run",
    description = "Simulates a scenario and writes steps.csv, summary.json and manifest.json.")
final class RunCommand implements Callable<Integer> {
  /** The size of a page that causes a warning. */
  private static final int LARGE_PAGE_MEGABYTES = 5;

  @Parameters(paramLabel = "SCENARIO.xml", description = "The scenario file.")
  private Path file;

  @Mixin private ScenarioOptions scenarioOptions;

  @Option(names = "--out", paramLabel = "DIR")
  private Optional<Path> out;

  @Option(names = "--record")
  private boolean record;

  @Option(names = "--heatmap")
  private boolean heatmap;

  @Option(names = "--cells", paramLabel = "N")
  private Optional<Integer> cells;

  @Option(names = "--listener", paramLabel = "NAME", showDefaultValue = NEVER)
  private List<String> listeners = new ArrayList<>();

  @Option(names = "--format", paramLabel = "FORMAT")
  private String format;

  @Option(names = "--json")
  private boolean json;

  @Mixin private Screen screen;

  @Mixin
  private final SettingOptions settings = SettingOptions.all().withoutDefault(Setting.NETWORK);

  @Override
  public Integer call() throws IOException {
    Instant started = Instant.now();
    int cellsAlong = cellsAlong();
    TableFormat tables = TableFormat.named(format);
    Catalogue catalogue = Catalogue.load();
    RunPlan plan = plan(catalogue);
    new RunExecutor(catalogue).check(plan);
    checkRecord(catalogue, plan);
    listeners.forEach(catalogue.listeners()::create);
    HeatRecorder heat =
        heatmap ? new HeatRecorder(world(plan, catalogue), plan.detection(), cellsAlong) : null;
    ReplayRecorder replay = record ? replay(plan, catalogue) : null;
    ScoreOverTime scores = new ScoreOverTime(plan.steps());
    Path folder = out.orElseGet(() -> Path.of("out", plan.scenario().name()));
    try (OutputFolder files = screen.folder(folder);
        RunFolder output = new RunFolder(files, plan.detection(), detail(plan), tables)) {
      List<RunResult> results =
          execute(
              plan,
              catalogue,
              run ->
                  Stream.of(
                      output.listener(run),
                      scores,
                      heat,
                      replay == null ? null : replay.listener(run)));
      ManifestFile.write(files, screen.words(), started, plan.work());
      if (replay != null) {
        replay.write(files.stream(ResultFolder.REPLAY));
      }
      HeatMap map = heat == null ? null : heat.map();
      if (map != null) {
        HeatTable.write(files, map);
      }
      InputFiles.write(files, List.of(plan));
      output.finish(plan, results);
      if (replay != null && tables == TableFormat.CSV) {
        files.write(ResultFolder.REPORT, page(files, folder));
      } else if (replay != null) {
        screen.note("no page: it is made of tables in CSV");
      }
      CrateFile.write(files, List.of(plan));
      output.commit();
      if (json) {
        screen.out().print(Files.readString(folder.resolve(ResultFolder.SUMMARY)));
      } else {
        RunSummary.print(screen.out(), plan, results, scores.means(), folder);
        if (map != null) {
          print(map);
        }
      }
    }
    return 0;
  }

  /** The number of cells along the field's longer side. */
  private int cellsAlong() {
    if (cells.isPresent() && !heatmap) {
      throw new InputException("--cells needs --heatmap");
    }
    return Numbers.inRange("--cells", cells.orElse(FieldCells.DEFAULT), 1, FieldCells.MAX);
  }

  private void print(HeatMap map) {
    screen.say(
        "heat map of %s x %s cells: %s", map.cells().columns(), map.cells().rows(), map.shares());
  }

  private static World world(RunPlan plan, Catalogue catalogue) {
    return new World(plan.scenario(), catalogue.movements(), plan.seed());
  }

  /** Rejects recording a policy that uses other angles than those that the scenario lists. */
  private void checkRecord(Catalogue catalogue, RunPlan plan) {
    if (record && catalogue.policies().create(plan.policy()) instanceof AimingZoomPolicy) {
      throw InputException.of(
          "policy '%s' turns cameras to any angle, which no recording holds: expected"
              + " another policy, or no --record",
          plan.policy());
    }
  }

  private Detail detail(RunPlan plan) {
    return record ? Detail.full(plan.scenario()) : Detail.STEPS;
  }

  private String page(OutputFolder files, Path folder) throws IOException {
    String html = Report.html(files.drafts(), ResultFolder.name(folder), Flags.NOTATION);
    warnOfSize(folder.resolve(ResultFolder.REPORT), html.length() / 1e6);
    return html;
  }

  private void warnOfSize(Path page, double megabytes) {
    if (megabytes >= LARGE_PAGE_MEGABYTES) {
      screen.note(
          "warning: %s has %.1f MB: where the cameras of this network stand, and what they see"
              + " at each zoom level, does not fit into %d MB",
          page, megabytes, LARGE_PAGE_MEGABYTES);
    }
  }

  /** Makes the plan, after checking all settings. */
  private RunPlan plan(Catalogue catalogue) {
    Settings asked = settings.settings();
    Scenario scenario = scenarioOptions.read(file, asked, catalogue, screen.err());
    Detection used = DetectionSpec.of(asked, scenario, file, catalogue);
    scenarioOptions.warnAbout(file, scenario, used, catalogue, screen.err());
    return asked.plan(scenario, used);
  }

  /**
   * Runs all repeats.
   *
   * @param recorders makes the recorders of a repeat; those that were not asked for are null
   */
  private List<RunResult> execute(
      RunPlan plan, Catalogue catalogue, IntFunction<Stream<StepListener>> recorders)
      throws IOException {
    long total = (long) plan.steps() * plan.repeats();
    try (Progress progress = screen.progress(plan.scenario().name(), " steps", total)) {
      StepListener counter = (network, coverage) -> progress.advance();
      return new RunExecutor(catalogue)
          .execute(
              plan,
              run ->
                  Stream.of(
                          recorders.apply(run).filter(Objects::nonNull),
                          Stream.of(counter),
                          listeners.stream().map(catalogue.listeners()::create))
                      .flatMap(Function.identity())
                      .toList());
    }
  }

  private ReplayRecorder replay(RunPlan plan, Catalogue catalogue) {
    List<Setup.Floor> floor = FloorPictures.of(file, plan.scenario());
    return new ReplayRecorder(
        Setup.of(world(plan, catalogue), plan.detection(), plan.policy(), plan.seed(), floor),
        plan.detection(),
        plan.repeats());
  }

  /**
   * Computes the mean score over all repeats in a few equal parts of the run; parts differ by one
   * step at most.
   */
  private static final class ScoreOverTime implements StepListener {
    private static final int MAX_PARTS = 40;

    private final int steps;
    private final double[] sums;
    private final long[] counts;

    /**
     * @param steps the number of steps of every repeat, 1 or more
     */
    ScoreOverTime(int steps) {
      this.steps = steps;
      this.sums = new double[Math.min(steps, MAX_PARTS)];
      this.counts = new long[sums.length];
    }

    @Override
    public void stepped(OracleView network, StepCoverage coverage) {
      int part = (int) (network.step() * sums.length / steps);
      sums[part] += coverage.score();
      counts[part]++;
    }

    /** The mean of each part; 0 if no step ran. */
    double[] means() {
      double[] means = new double[sums.length];
      Arrays.setAll(means, part -> sums[part] / Math.max(1, counts[part]));
      return means;
    }
  }
}
