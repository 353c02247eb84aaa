package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.placement.site.SitePlanner;
import org.hificamsim.presentation.replay.FloorPictures;
import org.hificamsim.presentation.view.Browsers;
import org.hificamsim.presentation.view.LiveChoice;
import org.hificamsim.presentation.view.LivePage;
import org.hificamsim.presentation.view.LiveRun;
import org.hificamsim.presentation.view.LiveSession;
import org.hificamsim.presentation.view.ViewServer;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim view}: shows a running scenario on an interactive page. */
@Command(
    name = "view",
    description = {
      "Shows a scenario live in the browser: choose models and policies, drag cameras, draw walls.",
      "Only this machine can open the page, and only by the printed address.",
      "Closing the page ends the command."
    })
final class ViewCommand implements Callable<Integer> {
  private static final int MAX_PORT = 65_535;
  private static final Duration GRACE = Duration.ofSeconds(5);

  @Parameters(paramLabel = "SCENARIO.xml", description = "The scenario file.")
  private Path file;

  @Mixin private ScenarioOptions scenarioOptions;

  @Option(names = "--port", paramLabel = "N")
  private int port;

  @Option(names = "--no-browser")
  private boolean noBrowser;

  @Spec private CommandSpec spec;

  @Mixin
  private final SettingOptions settings =
      SettingOptions.allBut(Setting.STEPS, Setting.REPEAT, Setting.NETWORK);

  @Override
  public Integer call() throws IOException, InterruptedException {
    Numbers.inRange("--port", port, 0, MAX_PORT);
    Catalogue catalogue = Catalogue.load();
    Settings asked = settings.settings();
    Scenario scenario =
        scenarioOptions.readSite(file, asked, catalogue, spec.commandLine().getErr());
    if (scenario.everyCamera().findAny().isEmpty()) {
      throw InputException.of(
          "%s: no <camera>, expected at least one to move: 'place %s --cameras 4' plans some",
          file, file);
    }
    DetectionSpec.of(
        asked, scenario, file, catalogue); // rejects a wrong one with its place in the file
    String detection = asked.value(Setting.DETECTION, scenario);
    Double threshold = asked.asked(Setting.THRESHOLD).map(Double::valueOf).orElse(null);
    LiveChoice choice = new LiveChoice(detection, threshold, asked.value(Setting.POLICY));
    LiveRun run =
        new LiveRun(
            catalogue,
            new LiveRun.ShownScenario(scenario, FloorPictures.of(file, scenario)),
            choice,
            asked.seed(),
            Optional.of(new SitePlanner(catalogue, DemandOptions.detections(catalogue))));
    String page = LivePage.html(catalogue, scenario.name(), detection);
    try (LiveSession session = new LiveSession(run);
        ViewServer server = new ViewServer(session, page, port, GRACE)) {
      spec.commandLine().getOut().println(server.address());
      spec.commandLine().getOut().flush();
      if (!noBrowser) {
        Browsers.open(server.address());
      }
      server.awaitEnd();
    }
    return 0;
  }
}
