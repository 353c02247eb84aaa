package org.hificamsim.cli;

import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.hificamsim.core.NamedSetting;
import org.hificamsim.core.Place;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.tracks.ImportSummary;
import org.hificamsim.tracks.Plausibility;
import org.hificamsim.tracks.SiteSettings;
import org.hificamsim.tracks.TrackSettings;
import org.hificamsim.tracks.TrackedSite;
import org.hificamsim.tracks.TracksImport;
import org.hificamsim.tracks.format.TrackFormat;
import org.hificamsim.tracks.ground.LocalProjection;
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
  @Parameters(paramLabel = "FILE", description = "The recording; may be packed (.gz).")
  private Path file;

  @Option(names = "--format", required = true, paramLabel = "F")
  private String format;

  @Option(names = "--out", required = true, paramLabel = "DIR")
  private Path out;

  @Option(names = "--force-reading")
  private boolean forceReading;

  @Mixin private RecordingOptions recording;
  @Mixin private SiteOptions site;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws IOException {
    TrackFormat reader = TrackFormat.registry().create(format);
    LocalProjection projection = recording.projection();
    String name = site.name(file);
    Destination.claim(spec, out, names(name));
    List<Obstacle> walls = site.walls(recording.unitOf(format), projection);
    SiteSettings siteSettings = site.settings(name, file, walls);
    TrackSettings settings = recording.settings();
    TracksImport tracks =
        new TracksImport(reader, recording.recording(file), recording.homography(), projection);
    ImportSummary summary = tracks.summary(settings, new Obstacles(walls));
    TrackedSite made = new TrackedSite(siteSettings, summary);
    List<String> signs = Plausibility.of(summary, made).signs(forceReading);
    try (OutputFolder folder = Destination.folder(spec, out)) {
      tracks.write(settings, folder, name + ".tracks");
      write(folder, name, made);
      folder.commit(List.of());
      print(name, summary, made, walls, projection);
      signs.forEach(this::warn);
    }
    return 0;
  }

  private void warn(String sign) {
    String line = NamedSetting.written(sign, Flags.NOTATION);
    spec.commandLine().getErr().println("warning: " + Place.printable(line));
  }

  /** The names of the files that are written. */
  private List<String> names(String name) {
    List<String> names = new ArrayList<>(List.of(name + ".xml", name + ".tracks"));
    if (site.floorplan() != null) {
      names.add(site.floorplanName(name));
    }
    return names;
  }

  private void write(OutputFolder folder, String name, TrackedSite made) throws IOException {
    if (site.floorplan() != null) {
      try (OutputStream copy = folder.stream(site.floorplanName(name))) {
        Files.copy(site.floorplan(), copy);
      }
    }
    try (Writer xml = folder.open(name + ".xml")) {
      xml.write(made.xml(name + ".tracks"));
    }
  }

  private void print(
      String name,
      ImportSummary summary,
      TrackedSite made,
      List<Obstacle> walls,
      LocalProjection projection) {
    PrintWriter terminal = spec.commandLine().getOut();
    terminal.println(out.resolve(name + ".xml"));
    summary.lines().forEach(line -> terminal.println("  " + Place.printable(line)));
    terminal.println("  " + recording.sizeLine(summary));
    if (!Double.isNaN(projection.longitude())) {
      terminal.println(
          Texts.format(
              "  projected to metres: equirectangular, WGS84, about latitude %s, longitude %s",
              projection.latitude(), projection.longitude()));
    }
    terminal.println("  " + site.line(made, walls));
    terminal.println("  " + made.question());
    terminal.println("Move the cameras, a first draft, and save them:");
    terminal.println("  ./hificamsim view " + out.resolve(name + ".xml"));
  }
}
