package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.presentation.view.Browsers;
import org.hificamsim.presentation.view.Choice;
import org.hificamsim.presentation.view.LivePage;
import org.hificamsim.presentation.view.LiveRun;
import org.hificamsim.presentation.view.Session;
import org.hificamsim.presentation.view.ViewServer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code hificamsim view}: a scenario as it runs, on a page that can be played with. */
@Command(
    name = "view",
    description = {
      "Shows a scenario live in the browser: choose models and policies, drag cameras.",
      "Only this machine can reach the page, and only by the address that is printed.",
      "Closing the page ends the command."
    },
    mixinStandardHelpOptions = true,
    showDefaultValues = true)
final class ViewCommand implements Callable<Integer> {
  private static final int MOST_PORT = 65_535;
  private static final Duration GRACE = Duration.ofSeconds(5);

  @Parameters(paramLabel = "SCENARIO.xml", description = "The scenario file.")
  private Path file;

  @Option(
      names = "--detection",
      paramLabel = "NAME|FILE.json[@T]",
      defaultValue = "hifi:orb-lin",
      description = "The detection model at first; see 'list detections'.")
  private String detection;

  @Option(
      names = "--policy",
      paramLabel = "NAME[:key=value,...]",
      defaultValue = "epsilon-greedy",
      description = "The zoom policy at first; see 'list policies'.")
  private String policy;

  @Option(names = "--seed", paramLabel = "N", defaultValue = "0", description = "Seed at first.")
  private long seed;

  @Option(
      names = "--port",
      paramLabel = "N",
      defaultValue = "0",
      description = "Port on the loopback device; 0 for any that is free.")
  private int port;

  @Option(names = "--no-browser", description = "Print the address, open no browser.")
  private boolean noBrowser;

  @Mixin private ScenarioOptions scenarioOptions;

  @Spec private CommandSpec spec;

  @Override
  public Integer call() throws IOException, InterruptedException {
    Numbers.inRange("--port", port, 0, MOST_PORT);
    Catalogue catalogue = Catalogue.load();
    Scenario scenario = scenarioOptions.read(file, catalogue, spec.commandLine().getErr());
    Choice choice = new Choice(detection, scenarioOptions.threshold(), policy);
    LiveRun run = new LiveRun(catalogue, scenario, choice, seed);
    String page = LivePage.html(catalogue, scenario.name(), detection);
    try (Session session = new Session(run);
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
