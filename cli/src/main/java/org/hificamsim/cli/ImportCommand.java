package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.tracks.ImportSummary;
import org.hificamsim.tracks.Plausibility;
import org.hificamsim.tracks.SiteSettings;
import org.hificamsim.tracks.TrackSettings;
import org.hificamsim.tracks.TrackedSite;
import org.hificamsim.tracks.TracksImport;
import org.hificamsim.tracks.format.FormatChoice;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.Drawing;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim import}: makes a scenario from recorded tracks. */
@Command(
    name = "import",
    description = "Makes a scenario from recorded tracks, walls and a floor plan.")
final class ImportCommand implements Callable<Integer> {
  @Parameters(
      arity = "1..*",
      paramLabel = "FILE",
      description = "The recording, in one or more files; may be packed (.gz).")
  private List<Path> files;

  @Option(names = "--format", paramLabel = "F")
  private String format;

  @Option(names = "--out", required = true, paramLabel = "DIR")
  private Path out;

  @Option(names = "--force-reading")
  private boolean forceReading;

  @Mixin private RecordingOptions recording;
  @Mixin private SiteOptions site;
  @Mixin private PlanOptions plan;

  @Option(names = "--walls", paramLabel = "FILE")
  private Path walls;

  @Option(names = "--step", paramLabel = "S")
  private Double step;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    List<FormatChoice> recordings =
        files.stream().map(file -> FormatChoice.of(format, recording.recording(file))).toList();
    LocalProjection projection = recording.projection();
    Unit unit = recordings.get(0).unit();
    String name = site.name(files.get(0));
    if (plan.listsLayers()) {
      return listLayers(unit, projection);
    }
    SiteOutput output = new SiteOutput(spec, name, plan.floorplan());
    output.claim(out, List.of(name + ".tracks"));
    Optional<Drawing> drawing = drawing(unit, projection);
    List<Obstacle> obstacles =
        drawing.map(read -> read.obstacles(plan.walkable())).orElse(List.of());
    SiteSettings siteSettings = settings(name, obstacles);
    TrackSettings settings = recording.settings();
    TracksImport tracks = new TracksImport(recordings, recording.homography(), projection);
    StringBuilder text = new StringBuilder(); // written to a file after all checks
    ImportSummary summary = tracks.write(settings, new Obstacles(obstacles), text);
    TrackedSite trackedSite = new TrackedSite(siteSettings, summary);
    List<String> warnings = Plausibility.of(summary, trackedSite).signs(forceReading);
    try (OutputFolder folder = Destination.folder(spec, out)) {
      folder.write(name + ".tracks", text.toString());
      output.write(folder, trackedSite.xml(name + ".tracks"));
      folder.commit(List.of());
      print(name, recordings, summary, projection);
      printSite(name, trackedSite, drawing.flatMap(Drawing::leftOut));
      warnings.forEach(output::warn);
    }
    return 0;
  }

  private int listLayers(Unit unit, LocalProjection projection) {
    if (walls == null) {
      throw new InputException("--list-layers is given without --walls, expected both");
    }
    Drawing drawing = drawing(unit, projection).orElseThrow();
    PlanOptions.printLayers(walls, drawing, spec.commandLine().getOut());
    return 0;
  }

  /** The walls; empty if no file is given. */
  private Optional<Drawing> drawing(Unit recordingUnit, LocalProjection projection) {
    Unit usual = recordingUnit == Unit.PX ? Unit.M : recordingUnit;
    return Optional.ofNullable(walls).map(drawn -> plan.read(drawn, usual, projection));
  }

  private SiteSettings settings(String name, List<Obstacle> obstacles) {
    return new SiteSettings(
        name,
        files.get(0),
        site.cameras(1),
        site.margin(),
        RecordingOptions.positive("--step", step),
        obstacles,
        plan.floorplan().map(image -> plan.floorplan(name, image)));
  }

  private void print(
      String name,
      List<FormatChoice> recordings,
      ImportSummary summary,
      LocalProjection projection) {
    PrintWriter terminal = spec.commandLine().getOut();
    terminal.println(out.resolve(name + ".xml"));
    recordings.forEach(
        choice ->
            choice.line().ifPresent(line -> terminal.println("  " + SiteOutput.printable(line))));
    summary.lines().forEach(line -> terminal.println("  " + SiteOutput.printable(line)));
    terminal.println("  " + recording.sizeLine(summary));
    PlanOptions.describeProjection(projection).ifPresent(line -> terminal.println("  " + line));
  }

  private void printSite(String name, TrackedSite trackedSite, Optional<String> leftOut) {
    PrintWriter terminal = spec.commandLine().getOut();
    Field field = trackedSite.field();
    terminal.println(
        "  field: %s x %s m; step: %s s; walls and solids: %s"
            .formatted(
                field.width(),
                field.height(),
                trackedSite.step(),
                trackedSite.obstacles().all().size()));
    leftOut.ifPresent(line -> terminal.println("  " + Place.printable(line)));
    terminal.println("  " + trackedSite.question());
    terminal.println("Move the cameras, a first draft, and save them:");
    terminal.println("  ./hificamsim view " + out.resolve(name + ".xml"));
  }
}
