package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.placement.site.PriceList;
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
      "With --new, begins a site on a floor plan: set its scale, draw it, and plan its cameras.",
      "Only this machine can open the page, and only by the printed address.",
      "Closing the page ends the command."
    })
final class ViewCommand implements Callable<Integer> {
  private static final int MAX_PORT = 65_535;
  private static final Duration GRACE_PERIOD = Duration.ofSeconds(5);

  @Parameters(arity = "0..1", paramLabel = "SCENARIO.xml", description = "The scenario file.")
  private Path scenarioFile;

  @Mixin private NewSiteOptions newSite;

  @Mixin private ScenarioOptions scenarioOptions;

  @Option(names = "--catalogue", paramLabel = "FILE.csv")
  private String kinds;

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
    if ((scenarioFile == null) == newSite.plan().isEmpty()) {
      throw new InputException("expected one of SCENARIO.xml and --new PLAN");
    }
    if (newSite.listsLayers()) {
      newSite.printLayers(spec.commandLine().getOut());
      return 0;
    }
    Path file = newSite.plan().orElse(scenarioFile);
    Scenario scenario = newSite.plan().isPresent() ? newSite.site() : read(asked, catalogue);
    // rejects an invalid detection with its place in the file
    DetectionSpec.of(asked, scenario, file, catalogue);
    String detection = asked.value(Setting.DETECTION, scenario);
    Double threshold = asked.asked(Setting.THRESHOLD).map(Double::valueOf).orElse(null);
    LiveChoice choice = new LiveChoice(detection, threshold, asked.value(Setting.POLICY));
    SitePlanner planner =
        new SitePlanner(
            catalogue, DemandOptions.detections(catalogue), PriceList.named(kinds, scenario));
    LiveRun run =
        new LiveRun(
            catalogue,
            new LiveRun.ShownScenario(scenario, FloorPictures.of(file, scenario)),
            choice,
            asked.seed(),
            Optional.of(planner));
    String page = LivePage.html(catalogue, scenario.name(), detection, tools(planner));
    try (LiveSession session = new LiveSession(run);
        ViewServer server = new ViewServer(session, page, port, GRACE_PERIOD)) {
      spec.commandLine().getOut().println(server.address());
      spec.commandLine().getOut().flush();
      if (!noBrowser) {
        Browsers.open(server.address());
      }
      server.awaitEnd();
    }
    return 0;
  }

  private Scenario read(Settings asked, Catalogue catalogue) {
    return scenarioOptions.readSite(scenarioFile, asked, catalogue, spec.commandLine().getErr());
  }

  private LivePage.DrawingTools tools(SitePlanner planner) {
    boolean isNew = newSite.plan().isPresent();
    return new LivePage.DrawingTools(planner.kinds(), isNew, !newSite.lacksScale());
  }
}
