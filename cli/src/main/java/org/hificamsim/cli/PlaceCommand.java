package org.hificamsim.cli;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleFunction;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Ranges;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.placement.output.PlanCheck;
import org.hificamsim.placement.output.PlanFiles;
import org.hificamsim.placement.site.Candidates;
import org.hificamsim.placement.site.CoverageReading;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.EvaluatedPlan;
import org.hificamsim.placement.site.PlacementProblem;
import org.hificamsim.placement.site.PlanCover;
import org.hificamsim.placement.site.PointSight;
import org.hificamsim.placement.site.PriceList;
import org.hificamsim.placement.site.Refinement;
import org.hificamsim.placement.site.SitePlan;
import org.hificamsim.presentation.replay.FloorPictures;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.solver.cover.CoverInstance;
import org.hificamsim.solver.cover.CoverPlan;
import org.hificamsim.solver.cover.CoverSearch;
import org.hificamsim.solver.cover.Effort;
import org.hificamsim.solver.cover.ExactMethod;
import org.hificamsim.solver.cover.Goal;
import org.hificamsim.solver.cover.InstanceFile;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim place}: plans where to put cameras, and bounds what is possible. */
@Command(
    name = "place",
    description = {
      "Plans where to put cameras on a site: by number, for a budget, or to cover everything.",
      "Also prints a bound on the coverage that no plan of the same candidates exceeds."
    })
final class PlaceCommand implements Callable<Integer> {
  private static final int MAX_CAMERAS = 100_000;

  /** The number of rounds without a better plan after which a search ends. */
  private static final int ROUNDS = 60;

  /** The share of the time that cameras may look from mount points. */
  private static final double SHARE_OF_LOOKING = 0.5;

  /** The share of the time after which the plan must be found, before it is made cheaper. */
  private static final double SHARE_OF_PLAN = 0.75;

  private static final double SHARE_BEFORE_REFINEMENT = 0.65;

  /** The share of the time for everything but measuring, drawing and writing the plan. */
  private static final double SHARE_OF_ALL = 0.85;

  /**
   * The shares of the search's time after which an exact method begins, and uses all candidates.
   */
  private static final double SHARE_BEFORE_EXACT = 0.2;

  private static final double SHARE_OF_FEW_CANDIDATES = 0.8;

  @Parameters(arity = "0..1", paramLabel = "SITE.xml", description = "The scenario of the site.")
  private Path file;

  @Option(names = "--cameras", paramLabel = "N")
  private Optional<Integer> cameras;

  @Option(names = "--budget", paramLabel = "EUR")
  private Optional<Double> budget;

  @Option(names = "--cover")
  private boolean cover;

  @Option(names = "--catalogue", paramLabel = "FILE.csv")
  private String kinds;

  @Option(names = "--method", paramLabel = "search|exact")
  private String method;

  @Option(names = "--refine")
  private boolean refine;

  @Option(names = "--time", paramLabel = "S")
  private double time;

  @Option(names = "--out", paramLabel = "DIR")
  private Optional<Path> out;

  @Option(names = "--verify", paramLabel = "DIR")
  private Optional<Path> verify;

  @Option(names = "--instance", paramLabel = "FILE")
  private Optional<Path> instance;

  @Option(names = "--form", paramLabel = "scp|candidates")
  private Optional<String> form;

  @Mixin private PlanFileOptions files;
  @Mixin private ReviewOptions review;
  @Mixin private DemandOptions demand;
  @Mixin private MountOptions mounts;
  @Mixin private ThreadsOption threads;
  @Mixin private ScenarioOptions scenarioOptions;
  @Mixin private Screen screen;

  @Mixin
  private final SettingOptions settings =
      SettingOptions.of(Setting.DETECTION, Setting.THRESHOLD, Setting.SEED);

  private String catalogueCurrency;

  private final Instant started = Instant.now();

  @Override
  public Integer call() throws IOException {
    if (verify.isPresent()) {
      return verify(verify.get());
    }
    if (!review.plans().isEmpty()) {
      return review(review.plans());
    }
    if ((file == null) == instance.isEmpty()) {
      throw new InputException(
          "expected one of SITE.xml, --instance FILE, --verify DIR, --evaluate PLAN.xml and"
              + " --compare PLAN.xml PLAN.xml");
    }
    Goal goal = goal();
    Ranges.within("--time", time, 0, 1e9);
    if (refine && (goal.isFullCover() || instance.isPresent())) {
      throw new InputException("--refine is for a site with --cameras N or --budget EUR");
    }
    if (instance.isPresent()) {
      return solve(instance.get(), goal);
    }
    String name = String.valueOf(file.getFileName()).replaceFirst("\\.[^.]*$", "");
    Path folder = out.orElse(Path.of("out", name + "-plan"));
    Interrupt interrupt = new Interrupt(started, time);
    PlacementProblem problem = problem(goal, interrupt);
    List<Setup.Floor> floor = FloorPictures.of(file, problem.demand().site());
    Optional<Refinement> refinement =
        refine ? Optional.of(refinement(problem.demand().site(), interrupt)) : Optional.empty();
    SitePlan plan =
        problem.solve(
            effort(interrupt), new SearchProgress(this::note, !goal.isFullCover()), refinement);
    try (OutputFolder output = screen.folder(folder)) {
      PlanFiles.write(output, plan, Catalogue.load(), content(file, floor, catalogueCurrency));
      files.write(output, plan);
      if (form.isPresent()) {
        try (Writer writer = output.open("instance.txt")) {
          InstanceFile.write(writer, problem.remaining(), instanceForm());
        }
      }
      ManifestFile.write(output, screen.words(), started, 0);
      ResultFolder.commit(output, List.of("instance.txt", PlanFiles.CANDIDATES));
    }
    print(plan, folder);
    return 0;
  }

  /** The method by which a plan is found. */
  private enum Method {
    SEARCH,
    EXACT
  }

  private Effort effort(Interrupt interrupt) {
    boolean exact = Spelling.require(Method.class, "--method", method) == Method.EXACT;
    double begin = interrupt.share();
    double end = refine ? SHARE_BEFORE_REFINEMENT : SHARE_OF_PLAN;
    DoubleFunction<BooleanSupplier> isOver =
        share -> () -> interrupt.isDue(begin + share * (end - begin));
    return new Effort(
        settings.settings().seed(),
        ROUNDS,
        exact ? Optional.of(ExactMethod.onClassPath()) : Optional.empty(),
        new Effort.Limits(
            isOver.apply(exact ? SHARE_BEFORE_EXACT : 1),
            isOver.apply(SHARE_OF_FEW_CANDIDATES),
            isOver.apply(1),
            () -> interrupt.isDue(SHARE_OF_ALL)));
  }

  private Refinement refinement(Scenario site, Interrupt interrupt) {
    List<List<Point>> denser =
        Stream.of(2, 4, 8).map(parts -> mounts.positions(site, parts)).toList();
    return new Refinement(denser, threads.count(), () -> interrupt.isDue(SHARE_OF_ALL));
  }

  private Goal goal() {
    if (goals() != 1 && !(goals() == 0 && instance.isPresent())) {
      throw new InputException("expected one of --cameras N, --budget EUR and --cover");
    }
    cameras.ifPresent(number -> Numbers.inRange("--cameras", number, 1, MAX_CAMERAS));
    budget.ifPresent(price -> Ranges.within("--budget", price, 1e-9, 1e12));
    return cameras
        .map(number -> new Goal(number))
        .or(() -> budget.map(Goal::new))
        .orElse(Goal.FULL_COVER);
  }

  private int goals() {
    return (cameras.isPresent() ? 1 : 0) + (budget.isPresent() ? 1 : 0) + (cover ? 1 : 0);
  }

  private PlacementProblem problem(Goal goal, Interrupt interrupt) throws IOException {
    Catalogue catalogue = Catalogue.load();
    Demand demanded = demand(file, catalogue);
    Scenario site = demanded.site();
    List<Point> positions = mounts.positions(site, 1);
    PriceList prices = PriceList.named(kinds, site);
    catalogueCurrency = prices.currency();
    PlacementProblem.Request request =
        new PlacementProblem.Request(
            demanded,
            new Candidates.Options(positions, prices.kinds()),
            demand.reading(),
            mounts.kept(site),
            new PlacementProblem.SiteGoal(goal, cameras.isPresent()));
    try (Progress looking = screen.progress("looks", " places", positions.size())) {
      return PlacementProblem.of(
          request,
          catalogue,
          new Candidates.Work(
              threads.count(), () -> interrupt.isDue(SHARE_OF_LOOKING), looking::advance));
    }
  }

  private Demand demand(Path scenario, Catalogue catalogue) {
    Settings asked = settings.settings();
    Scenario site = scenarioOptions.readSite(scenario, asked, catalogue, screen.err());
    Detection usual = DetectionSpec.of(asked, site, scenario, catalogue);
    Demand demanded = demand.demand(site, usual, catalogue);
    demanded.assumptions().forEach(assumption -> screen.say("%s", assumption));
    return demanded;
  }

  private int review(List<Path> plans) throws IOException {
    if (file != null || goals() > 0 || instance.isPresent()) {
      throw new InputException(
          "--evaluate and --compare measure plans as they are, expected no site, instance or goal"
              + " besides");
    }
    if (plans.size() > 1 && out.isPresent()) {
      throw new InputException("--out writes the documents of one plan, expected --evaluate");
    }
    Catalogue catalogue = Catalogue.load();
    List<PlanReview> reviews =
        plans.stream().map(plan -> new PlanReview(plan, evaluated(plan, catalogue))).toList();
    if (reviews.size() == 1) {
      reviews.get(0).print(screen);
      if (out.isPresent()) {
        writeDocuments(reviews.get(0), out.get(), catalogue);
      }
    } else {
      PlanReview.compare(screen, reviews.get(0), reviews.get(1));
    }
    return 0;
  }

  private void writeDocuments(PlanReview review, Path folder, Catalogue catalogue)
      throws IOException {
    EvaluatedPlan plan = review.plan();
    List<Setup.Floor> floor = FloorPictures.of(review.file(), plan.demand().site());
    try (OutputFolder output = screen.folder(folder)) {
      PlanFiles.Content content = content(review.file(), floor, PriceList.USUAL_CURRENCY);
      PlanFiles.writeDocuments(output, plan, List.of(), catalogue, content);
      ManifestFile.write(output, screen.words(), started, 0);
      ResultFolder.commit(output, List.of());
    }
    screen.out().println(folder + "/index.html, plan.pdf");
  }

  private PlanFiles.Content content(Path site, List<Setup.Floor> floor, String currency) {
    return new PlanFiles.Content(site, floor, files.title(currency), screen.words(), this::note);
  }

  private EvaluatedPlan evaluated(Path plan, Catalogue catalogue) {
    Demand demanded = demand(plan, catalogue);
    PointSight sight = new PointSight(demanded, catalogue);
    try (Progress measuring = screen.progress("measures", " zones", demanded.zones().size())) {
      CoverageReading reading = demand.reading();
      return new EvaluatedPlan(
          PlanCover.of(demanded, sight, demanded.site().cameras(), reading, measuring::advance),
          reading);
    }
  }

  /** Prints an event of the search after the seconds since the start. */
  private void note(String event) {
    screen.note("%6.1f s: %s", seconds(), event);
  }

  private double seconds() {
    return Duration.between(started, Instant.now()).toMillis() / 1e3;
  }

  private void print(SitePlan plan, Path folder) {
    Demand demanded = plan.demand();
    List<String> facts = plan.facts();
    screen.say("%s", facts.get(0));
    facts.stream().skip(1).forEach(fact -> screen.say("  %s", fact));
    screen.say(
        "  %d candidates at %d places, %d samples, cells of %s m, %.1f s",
        plan.problem().candidates().list().size(),
        plan.problem().candidates().places(),
        demanded.points().size(),
        cellWidths(demanded),
        seconds());
    PlanReview.printZones(screen, plan.cover());
    PlanFiles.omission(plan).ifPresent(reason -> screen.say("  %s", reason));
    screen.say(
        "%s/index.html, plan.pdf; under policies: ./hificamsim compare %s",
        folder, folder.resolve(PlanFiles.SCENARIO));
  }

  private static String cellWidths(Demand demand) {
    String finest = Texts.format("%.2f", demand.finestCells().width());
    String widest = Texts.format("%.2f", demand.greatestCellWidth());
    return finest.equals(widest) ? finest : finest + " to " + widest;
  }

  private InstanceFile.Form instanceForm() {
    return Spelling.require(InstanceFile.Form.class, "--form", form.orElse("scp"));
  }

  private int solve(Path path, Goal goal) throws IOException {
    CoverInstance whole = InstanceFile.read(path, instanceForm());
    CoverInstance solved = goal.isFullCover() ? whole.coverable() : whole;
    Effort effort = effort(new Interrupt(started, time));
    CoverPlan plan = CoverSearch.solve(solved, goal, effort, new SearchProgress(this::note, false));
    screen.say(
        "%d of %d candidates, price %.2f, see %.0f of %d samples",
        plan.chosen().length,
        solved.candidates(),
        solved.price(plan.chosen()),
        solved.worth(solved.counts(plan.chosen())),
        solved.points());
    screen.say(
        "score %.2f, bound %.2f, gap %.3f %%, %.1f s",
        plan.score(), plan.bound(), 100 * plan.gap(), plan.seconds());
    if (plan.isProven()) {
      screen.say(
          "proven of %s and %s: no plan of these is better",
          Texts.counted(solved.points(), "sample"),
          Texts.counted(solved.candidates(), "candidate"));
    }
    return 0;
  }

  private int verify(Path folder) throws IOException {
    Catalogue catalogue = Catalogue.load();
    if (!Files.isRegularFile(folder.resolve(PlanFiles.SCENARIO))) {
      throw new InputException("no plan in '" + folder + "', expected a folder that 'place' wrote");
    }
    PlanCheck check =
        new PlanCheck(
            folder,
            path -> scenarioOptions.readSite(path, Settings.NONE, catalogue, screen.err()),
            catalogue,
            DemandOptions.detections(catalogue),
            effort(new Interrupt(started, time)));
    try (Progress simulating = screen.progress("simulates", " cameras", check.simulated())) {
      check.check(simulating::advance).forEach(line -> screen.out().println(line));
    }
    screen.say("checked in %.1f s", seconds());
    return 0;
  }
}
