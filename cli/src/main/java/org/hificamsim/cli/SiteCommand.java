package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.generate.FreePositions;
import org.hificamsim.tracks.DrawnSite;
import org.hificamsim.tracks.Plausibility;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.Drawing;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim site}: makes a scenario from a floor plan. */
@Command(
    name = "site",
    description = "Makes a scenario from a floor plan: a drawing, a map or a picture.")
final class SiteCommand implements Callable<Integer> {
  private static final int MAX_PEOPLE = 100_000;

  @Parameters(
      paramLabel = "PLAN",
      description = "SVG, DXF, GeoJSON, well-known text, JuPedSim's XML or SQLite, PNG or JPEG.")
  private Path file;

  @Option(names = "--out", paramLabel = "DIR")
  private Optional<Path> out;

  @Option(names = "--people", paramLabel = "N")
  private int people;

  @Option(names = "--force-reading")
  private boolean forceReading;

  @Mixin private SiteOptions site;
  @Mixin private PlanOptions plan;
  @Mixin private final SettingOptions random = SettingOptions.of(Setting.SEED);
  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    Numbers.inRange("--people", people, 0, MAX_PEOPLE);
    LocalProjection projection = new LocalProjection();
    PlanReader reader = new PlanReader(file, plan);
    Optional<Drawing> drawing = reader.drawing(projection);
    if (plan.listsLayers()) {
      reader.printLayers(drawing, spec.commandLine().getOut());
      return 0;
    }
    Path folder =
        out.orElseThrow(() -> new InputException("expected --out DIR, a folder for the site"));
    String name = site.name(file);
    Optional<Path> picture = reader.isPicture() ? Optional.of(file) : plan.floorplan();
    SiteOutput output = new SiteOutput(spec, name, picture);
    output.claim(folder, List.of());
    Optional<Floorplan> floorplan = picture.map(image -> plan.floorplan(name, image));
    DrawnSite drawnSite = reader.site(name, site.cameras(0), site.margin(), drawing, floorplan);
    List<String> warnings = Plausibility.of(drawnSite).signs(forceReading);
    Scenario empty = drawnSite.scenario();
    long seed = random.settings().seed();
    Scenario scenario = empty.with(Scenario.TARGETS, FreePositions.people(empty, people, seed));
    try (OutputFolder written = Destination.folder(spec, folder)) {
      output.write(written, drawnSite.xml(scenario));
      written.commit(List.of());
    }
    print(
        folder.resolve(output.scenarioFile()),
        drawnSite,
        drawing.flatMap(Drawing::leftOut),
        projection);
    warnings.forEach(output::warn);
    return 0;
  }

  private void print(
      Path scenario, DrawnSite drawnSite, Optional<String> leftOut, LocalProjection projection) {
    PrintWriter terminal = spec.commandLine().getOut();
    Field field = drawnSite.field();
    terminal.println(scenario);
    terminal.println(
        Texts.format(
            "  field: %s x %s m; walls and solids: %s",
            field.width(), field.height(), drawnSite.obstacles().all().size()));
    leftOut.ifPresent(line -> terminal.println("  " + Place.printable(line)));
    PlanOptions.describeProjection(projection).ifPresent(line -> terminal.println("  " + line));
    terminal.println(
        Texts.format(
            "  draft cameras: %s; people who walk at random: %s", site.cameras(0), people));
    terminal.println("  " + drawnSite.question());
    terminal.println(
        site.cameras(0) > 0 ? "Plan its cameras, or move them by hand:" : "Plan its cameras:");
    terminal.println(Texts.format("  ./hificamsim place %s --cameras 4", scenario));
    if (site.cameras(0) > 0) {
      terminal.println(Texts.format("  ./hificamsim view %s", scenario));
    }
  }
}
