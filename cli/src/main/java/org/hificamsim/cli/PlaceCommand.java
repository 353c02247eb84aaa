package org.hificamsim.cli;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Function;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.placement.cover.CoverInstance;
import org.hificamsim.placement.cover.CoverPlan;
import org.hificamsim.placement.cover.CoverSearch;
import org.hificamsim.placement.cover.Effort;
import org.hificamsim.placement.cover.ExactMethod;
import org.hificamsim.placement.cover.Goal;
import org.hificamsim.placement.cover.InstanceFile;
import org.hificamsim.placement.output.PlanCheck;
import org.hificamsim.placement.output.PlanFiles;
import org.hificamsim.placement.site.BlindSpot;
import org.hificamsim.placement.site.CameraKind;
import org.hificamsim.placement.site.Candidates;
import org.hificamsim.placement.site.CoverageReading;
import org.hificamsim.placement.site.Demand;
import org.hificamsim.placement.site.MountPoints;
import org.hificamsim.placement.site.PlacementProblem;
import org.hificamsim.placement.site.Refinement;
import org.hificamsim.placement.site.SitePlan;
import org.hificamsim.placement.site.Visits;
import org.hificamsim.presentation.replay.FloorPictures;
import org.hificamsim.presentation.replay.Setup;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.ResultFolder;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim place}: where to put the cameras, and how good that is. */
@Command(
    name = "place",
    description = {
      "Plans where to put cameras on a site: by number, for a budget, or to cover everything.",
      "Also prints a bound on the coverage that no plan of the same candidates exceeds."
    })
final class PlaceCommand implements Callable<Integer> {
  private static final int MAX_CAMERAS = 100_000;
  private static final int ROUNDS = 60; // without a better plan
  private static final double SEARCHED = 0.2; // of the time, before an exact method goes on
  private static final double TRIED = 0.8; // of the time, before it goes on with all candidates
  private static final double REFINED = 0.7; // of the time, before cameras are moved
  private static final int USUAL_CELLS = 60;
  private static final String UNKNOWN = "%s: the site has no %s '%s', expected the name of one";
  private static final int SPOTS = 3; // that the terminal names
  private static final double USUAL_PLACES = 40; // along the longer side of the field

  @Parameters(arity = "0..1", paramLabel = "SITE.xml", description = "The scenario of the site.")
  private Path file;

  @Option(names = "--cameras", paramLabel = "N")
  private Optional<Integer> cameras;

  @Option(names = "--budget", paramLabel = "EUR")
  private Optional<Double> budget;

  @Option(names = "--cover")
  private boolean cover;

  @Option(names = "--reading", paramLabel = "fixed|any")
  private String reading;

  @Option(names = "--catalogue", paramLabel = "FILE.csv")
  private String kinds;

  @Option(names = "--candidates", paramLabel = "every=M|FILE.csv")
  private Optional<String> candidates;

  @Option(names = "--keep", paramLabel = "all|A,B")
  private Optional<String> keep;

  @Option(names = "--forbid", paramLabel = "ZONE,ZONE")
  private Optional<String> forbid;

  @Option(names = "--redundancy", paramLabel = "K")
  private Optional<Integer> redundancy;

  @Option(names = "--demand", paramLabel = "zones|tracks")
  private String demand;

  @Option(names = "--cells", paramLabel = "N")
  private Optional<Integer> cells;

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

  @Mixin private ThreadsOption threads;
  @Mixin private ScenarioOptions scenarioOptions;
  @Mixin private Screen screen;

  @Mixin
  private final SettingOptions settings =
      SettingOptions.of(Setting.DETECTION, Setting.THRESHOLD, Setting.SEED);

  @Override
  public Integer call() throws IOException {
    Instant started = Instant.now();
    if (verify.isPresent()) {
      return verify(verify.get());
    }
    if ((file == null) == instance.isEmpty()) {
      throw new InputException("expected one of SITE.xml, --instance FILE and --verify DIR");
    }
    Goal goal = goal();
    Numbers.within("--time", time, 0, 1e9);
    if (refine && (goal.isFullCover() || instance.isPresent())) {
      throw new InputException("--refine is for a site with --cameras N or --budget EUR");
    }
    if (instance.isPresent()) {
      return solve(instance.get(), goal);
    }
    String plain = String.valueOf(file.getFileName()).replaceFirst("\\.[^.]*$", "");
    Path folder = out.orElse(Path.of("out", plain + "-plan"));
    PlacementProblem problem = problem(goal);
    List<Setup.Floor> floor = FloorPictures.of(file, problem.demand().site());
    Interrupt interrupt = new Interrupt(time);
    Optional<Refinement> refinement =
        Optional.of(problem).filter(p -> refine).map(p -> refinement(p.demand().site(), interrupt));
    SitePlan plan = problem.solve(effort(interrupt), watcher(!goal.isFullCover()), refinement);
    try (OutputFolder output = screen.folder(folder)) {
      PlanFiles.write(output, plan, Catalogue.load(), floor, screen.words());
      if (form.isPresent()) {
        try (Writer writer = output.open("instance.txt")) {
          InstanceFile.write(writer, problem.remaining(), instanceForm());
        }
      }
      ManifestFile.write(output, screen.words(), started, 0);
      ResultFolder.commit(output, List.of("instance.txt"));
    }
    tell(plan, folder);
    return 0;
  }

  private enum Method {
    SEARCH,
    EXACT
  }

  private Effort effort(Interrupt interrupt) {
    boolean exact = Spelling.require(Method.class, "--method", method) == Method.EXACT;
    double part = refine ? REFINED : 1;
    return new Effort(
        settings.settings().seed(),
        ROUNDS,
        exact ? Optional.of(ExactMethod.onClassPath()) : Optional.empty(),
        new Effort.Limits(
            () -> interrupt.isDue(SEARCHED * part),
            () -> interrupt.isDue(TRIED * part),
            () -> interrupt.isDue(part)));
  }

  private Refinement refinement(Scenario site, Interrupt interrupt) {
    List<List<Point>> closer = Stream.of(2, 4, 8).map(parts -> places(site, parts)).toList();
    return new Refinement(closer, threads.count(), interrupt::isDue);
  }

  private Goal goal() {
    int asked = (cameras.isPresent() ? 1 : 0) + (budget.isPresent() ? 1 : 0) + (cover ? 1 : 0);
    if (asked != 1 && !(asked == 0 && instance.isPresent())) {
      throw new InputException("expected one of --cameras N, --budget EUR and --cover");
    }
    cameras.ifPresent(n -> Numbers.inRange("--cameras", n, 1, MAX_CAMERAS));
    budget.ifPresent(price -> Numbers.within("--budget", price, 1e-9, 1e12));
    return cameras.map(n -> new Goal(n)).or(() -> budget.map(Goal::new)).orElse(Goal.FULL_COVER);
  }

  private PlacementProblem problem(Goal goal) throws IOException {
    Catalogue catalogue = Catalogue.load();
    Settings asked = settings.settings();
    Scenario site = scenarioOptions.read(file, asked, catalogue, screen.err());
    Detection detection = DetectionSpec.of(asked, site, file, catalogue);
    FieldCells grid =
        FieldCells.of(
            site.field(), Numbers.inRange("--cells", cells.orElse(USUAL_CELLS), 1, FieldCells.MAX));
    redundancy.ifPresent(k -> Numbers.inRange("--redundancy", k, 1, 100));
    Of of = Spelling.require(Of.class, "--demand", demand);
    Demand all =
        Demand.of(
            site,
            grid,
            redundancy,
            new Demand.Detections(detection, detections(catalogue)),
            of == Of.TRACKS ? Optional.of(Visits.of(site, grid, catalogue)) : Optional.empty());
    CoverageReading read = Spelling.require(CoverageReading.class, "--reading", reading);
    return PlacementProblem.of(
        new PlacementProblem.Request(
            all,
            new Candidates.Options(places(site, 1), CameraKind.catalogue(kinds, site)),
            read,
            kept(site),
            new PlacementProblem.SiteGoal(goal, cameras.isPresent())),
        catalogue,
        threads.count());
  }

  private enum Of {
    ZONES,
    TRACKS
  }

  /** Detections that zones name. */
  static Function<String, Detection> detections(Catalogue catalogue) {
    return name -> DetectionSpec.parse(name, catalogue::detection).detection(Settings.NONE);
  }

  /** The places of candidates, or between them where these are {@code parts} times closer. */
  private List<Point> places(Scenario site, int parts) {
    List<Zone> forbidden = named("--forbid", forbid, "zone", site.zones(), Zone::name);
    double longer = Math.max(site.field().width(), site.field().height());
    String text = candidates.orElse("every=" + longer / USUAL_PLACES);
    if (!text.startsWith("every=")) {
      return MountPoints.read(Path.of(text), site, forbidden);
    }
    boolean ceiling = text.endsWith(",ceiling");
    String number = text.substring("every=".length()).replaceFirst(",ceiling$", "");
    try {
      double every =
          Numbers.within("--candidates every", Double.parseDouble(number), longer / 1000, longer);
      return MountPoints.of(site, every / parts, ceiling, forbidden);
    } catch (NumberFormatException e) {
      throw new InputException(
          "--candidates is '" + text + "', expected every=M, every=M,ceiling or a table", e);
    }
  }

  private List<CameraSpec> kept(Scenario site) {
    return keep.equals(Optional.of("all"))
        ? site.cameras()
        : named("--keep", keep, "camera", site.cameras(), CameraSpec::name);
  }

  /** What an option names of a site. */
  private static <T> List<T> named(
      String option, Optional<String> list, String kind, List<T> all, Function<T, String> name) {
    return list.stream()
        .flatMap(text -> Stream.of(text.split(",")))
        .map(
            asked ->
                all.stream()
                    .filter(one -> name.apply(one).equals(asked))
                    .findFirst()
                    .orElseThrow(() -> InputException.of(UNKNOWN, option, kind, asked)))
        .toList();
  }

  /** Prints the plan and the bound where they have changed: as shares, or as they are. */
  private CoverSearch.Watcher watcher(boolean shares) {
    long started = System.nanoTime();
    String unit = shares ? " %%" : "";
    String form = "plan %.2f" + unit + ", bound %.2f" + unit + ", gap %.2f %%";
    String[] before = {""};
    return (score, limit) -> {
      double bound = shares ? Math.min(1, limit) : limit; // no plan meets more than all
      double gap = Math.abs(bound - score) / Math.max(Math.abs(bound), Math.abs(score));
      int by = shares ? 100 : 1;
      String now = Texts.format(form, by * score, by * bound, 100 * gap);
      if (!now.equals(before[0])) {
        screen.note("%6.1f s: %s", (System.nanoTime() - started) / 1e9, now);
      }
      before[0] = now;
    };
  }

  private void tell(SitePlan plan, Path folder) {
    Demand all = plan.demand();
    List<String> facts = plan.facts();
    screen.say("%s", facts.get(0));
    facts.stream().skip(1).forEach(fact -> screen.say("  %s", fact));
    screen.say(
        "  %d candidates, %d samples, cells of %.2f m, %.1f s",
        plan.problem().candidates().list().size(),
        all.points().size(),
        all.cells().width(),
        plan.coverPlan().seconds());
    for (Demand.ZoneDemand zone : all.zones()) {
      screen.say(
          "  zone %s: %.2f %% by %s, k = %d",
          zone.name(), 100 * all.share(zone, plan.counts()), zone.detection().name(), zone.k());
    }
    List<BlindSpot> spots = plan.blindSpots();
    spots.stream().limit(SPOTS).forEach(spot -> screen.say("  seen by no camera: %s", spot));
    if (spots.size() > SPOTS) {
      screen.say("  and %d more places", spots.size() - SPOTS);
    }
    screen.say(
        "%s/index.html, plan.pdf; under policies: ./hificamsim compare %s",
        folder, folder.resolve(PlanFiles.SCENARIO));
  }

  private InstanceFile.Form instanceForm() {
    return Spelling.require(InstanceFile.Form.class, "--form", form.orElse("scp"));
  }

  private int solve(Path path, Goal goal) throws IOException {
    CoverInstance read = InstanceFile.read(path, instanceForm());
    CoverInstance all = goal.isFullCover() ? read.coverable() : read;
    Effort effort = effort(new Interrupt(time));
    CoverPlan plan = CoverSearch.solve(all, goal, effort, watcher(false));
    screen.say(
        "%d of %d candidates, price %.2f, see %.0f of %d samples",
        plan.chosen().length,
        all.candidates(),
        all.price(plan.chosen()),
        all.worth(all.counts(plan.chosen())),
        all.points());
    screen.say(
        "score %.2f, bound %.2f, gap %.3f %%, %.1f s",
        plan.score(), plan.bound(), 100 * plan.gap(), plan.seconds());
    if (plan.isProven()) {
      screen.say("proven: no plan is better");
    }
    return 0;
  }

  private int verify(Path folder) throws IOException {
    Catalogue catalogue = Catalogue.load();
    if (!Files.isRegularFile(folder.resolve(PlanFiles.SCENARIO))) {
      throw new InputException("no plan in '" + folder + "', expected a folder that 'place' wrote");
    }
    PlanCheck.check(
            folder,
            path -> scenarioOptions.read(path, Settings.NONE, catalogue, screen.err()),
            catalogue,
            detections(catalogue),
            effort(new Interrupt(time)))
        .forEach(line -> screen.out().println(line));
    return 0;
  }
}
