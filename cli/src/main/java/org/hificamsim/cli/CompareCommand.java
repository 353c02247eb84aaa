package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.presentation.figures.ComparisonFigures;
import org.hificamsim.presentation.figures.FigureStyle;
import org.hificamsim.presentation.plot.PrintWidth;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.Reach;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.compare.AggregateFiles;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.Choice;
import org.hificamsim.runs.compare.ComparisonFiles;
import org.hificamsim.runs.compare.PolicyScores;
import org.hificamsim.runs.compare.ReferencePolicies;
import org.hificamsim.runs.compare.ReferencePolicy;
import org.hificamsim.runs.compare.SummaryTables;
import org.hificamsim.runs.compare.Yardstick;
import org.hificamsim.runs.hints.OptimumTime;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim compare}: runs all combinations of scenarios, detections, policies, seeds. */
@Command(
    name = "compare",
    description = "Compares policies and detection models over scenarios and seeds.")
final class CompareCommand implements Callable<Integer> {
  private static final Duration LEAST_FORECAST = Duration.ofMinutes(2);

  @Parameters(arity = "1..*", paramLabel = "SCENARIO.xml", description = "The scenario files.")
  private List<Path> files;

  @Option(names = "--detections", paramLabel = "A,B[@T]")
  private String detections;

  @Option(names = "--policies", paramLabel = "P,Q")
  private String policies;

  @Option(names = "--yardsticks", paramLabel = "Y,Z")
  private String yardsticks;

  @Option(names = "--reference", paramLabel = "P|all")
  private String reference;

  @Option(names = "--latex")
  private boolean latex;

  @Option(names = "--details")
  private boolean details;

  @Spec private CommandSpec command;

  @Mixin private ScenarioOptions scenarioOptions;

  @Mixin private BatchRun batch;

  @Mixin private FigureOptions figures;

  @Mixin private Screen screen;

  @Mixin
  private final SettingOptions settings =
      SettingOptions.allBut(Setting.DETECTION, Setting.POLICY, Setting.NETWORK);

  @Override
  public Integer call() throws IOException {
    Catalogue catalogue = Catalogue.load();
    List<RunPlan> plans = plans(catalogue);
    Optional<PrintWidth> width = figures.width();
    FigureStyle style = figures.style(plans);
    ReferencePolicies references = ReferencePolicies.parse("--yardsticks", yardsticks);
    ReferencePolicy compared =
        ReferencePolicy.of(reference, NameLists.policies(policies, catalogue.policies()));
    if (batch.computesHere()) {
      new OptimumTime(catalogue, batch.threads())
          .forecast(plans, references)
          .filter(forecast -> forecast.total().compareTo(LEAST_FORECAST) > 0)
          .ifPresent(forecast -> screen.err().println(sentence(forecast)));
    }
    return batch.execute(
        screen,
        catalogue,
        references,
        plans,
        (folder, results) -> {
          List<CaseResult> requested = results.subList(0, plans.size());
          ComparisonFiles.write(folder, requested, results);
          Choice.write(folder, requested);
          style.write(folder, List.copyOf(Cases.byPolicy(requested).keySet()));
          ComparisonFigures.write(folder, results, width, style, batch.threads());
          AggregateFiles.write(folder, requested, compared, batch.threads());
          if (latex) {
            SummaryTables.writeLatex(folder, requested, results, style::name);
          }
          return out -> {
            print(out, results);
            AggregateFiles.tooFewSeeds(requested, compared).ifPresent(out::println);
            requested.stream()
                .map(result -> result.plan().policy())
                .distinct()
                .filter(catalogue::isBound)
                .map(policy -> policy + " is a bound: it knows what no camera can know")
                .forEach(out::println);
          };
        });
  }

  static String sentence(OptimumTime.Forecast forecast) {
    double seconds = forecast.secondsPerStep();
    return Texts.format(
        "the optimum of %s takes up to "
            + (seconds < 10 ? "%.2g" : "%.0f")
            + " s a step, all optima up to %d:%02d hours; --yardsticks bound takes a small part of"
            + " it",
        forecast.slowest(),
        seconds,
        forecast.total().toHours(),
        forecast.total().toMinutesPart());
  }

  private List<RunPlan> plans(Catalogue catalogue) {
    Settings asked = settings.settings();
    List<DetectionSpec> specs = NameLists.detections(detections, catalogue);
    List<String> policySpecs = NameLists.policies(policies, catalogue.policies());
    List<Scenario> scenarios = scenarioOptions.read(files, asked, catalogue, screen.err());
    List<RunPlan> plans = new ArrayList<>();
    for (int i = 0; i < files.size(); i++) {
      for (RunPlan plan : plans(asked, scenarios.get(i), files.get(i), specs, catalogue)) {
        scenarioOptions.warnAbout(
            files.get(i), plan.scenario(), plan.detection(), catalogue, screen.err());
        policySpecs.forEach(policy -> plans.add(plan.withPolicy(policy)));
      }
    }
    return plans;
  }

  /** Makes a plan for each listed detection, or for the scenario's, or for the default ones. */
  private List<RunPlan> plans(
      Settings asked,
      Scenario scenario,
      Path file,
      List<DetectionSpec> specs,
      Catalogue catalogue) {
    boolean isListed = command.commandLine().getParseResult().hasMatchedOption("--detections");
    if (!isListed && scenario.find(Scenario.DETECTION).isPresent()) {
      return List.of(asked.plan(scenario, DetectionSpec.of(asked, scenario, file, catalogue)));
    }
    List<RunPlan> plans = new ArrayList<>();
    for (DetectionSpec spec : specs) {
      Settings withSpec =
          isListed
              ? asked.with(Setting.DETECTION, spec.text())
              : asked.orElse(Setting.DETECTION, spec.text());
      plans.add(withSpec.plan(scenario, spec.detection(withSpec, scenario)));
    }
    NameLists.requireDistinct(
        "--detections", plans.stream().map(plan -> plan.detection().name()).toList());
    return plans;
  }

  private void print(PrintWriter out, List<CaseResult> cases) {
    SummaryTables.meanings(cases).forEach(out::println);
    (details ? SummaryTables.casesInFull(cases) : SummaryTables.cases(cases)).print(out);
    if (cases.stream().allMatch(result -> result.mean(Metric.SCORE).mean() == 0)) {
      printCoverage(out, cases);
    }
    SummaryTables.sharesOfBound(cases).forEach(out::println);
    if (details) {
      printDetails(out, cases);
    }
  }

  /** Prints the policies that detections choose, and the aggregates over all scenarios. */
  private static void printDetails(PrintWriter out, List<CaseResult> cases) {
    List<Choice> choices = Choice.of(cases);
    if (!choices.isEmpty()) {
      out.println();
      out.println(
          "what the policy that each detection chooses achieves, mean score of a step (of k_min by"
              + " chance: the expected one):");
      Choice.table(choices).print(out);
    }
    List<PolicyScores> policies =
        PolicyScores.of(cases.stream().filter(result -> !result.isOptimum()).toList());
    Optional<Yardstick> yardstick = Yardstick.of(cases);
    if (yardstick.isPresent() && policies.stream().anyMatch(policy -> policy.cases().size() > 1)) {
      out.println();
      out.println("all scenarios, " + yardstick.get().title() + ":");
      SummaryTables.aggregates(policies).print(out);
    }
  }

  /** Prints the shares of targets if all scores are 0, and the reach of each detection. */
  private static void printCoverage(PrintWriter out, List<CaseResult> cases) {
    out.println("no step had every target covered, so performance is 0; shares of targets:");
    SummaryTables.coverage(cases).print(out);
    cases.stream().map(result -> reach(result.plan())).distinct().forEach(out::println);
  }

  private static String reach(RunPlan plan) {
    return plan.scenario().name()
        + ", "
        + plan.detection().name()
        + (plan.detection().certain() ? ": detected up to " : ": detected half of the time up to ")
        + Reach.describe(plan.scenario(), plan.detection());
  }
}
