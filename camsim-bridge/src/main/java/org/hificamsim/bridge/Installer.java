package org.hificamsim.bridge;

import java.io.IOException;
import java.lang.instrument.Instrumentation;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.hificamsim.bridge.agent.FaultLine;
import org.hificamsim.bridge.agent.Hooks;
import org.hificamsim.bridge.camsim.Requirements;
import org.hificamsim.bridge.camsim.Weaver;
import org.hificamsim.bridge.run.BridgeSettings;
import org.hificamsim.bridge.run.LiveBridge;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.OutputFolder;

/**
 * Reads the options, makes sure that this CamSim has what they need, and has the hooks woven into
 * its classes as the JVM loads them. Nothing is installed when anything is wrong.
 */
public final class Installer implements BiConsumer<String, Instrumentation> {
  @Override
  public void accept(String options, Instrumentation instrumentation) {
    boolean strict = FaultLine.strict(options);
    try {
      BridgeSettings settings = BridgeOptions.parse(options, catalogue());
      if (settings.asksForAnything()) {
        check(settings);
        install(settings, instrumentation, strict);
      }
    } catch (InputException e) {
      FaultLine.tell(Place.printable(e.getMessage()), strict);
    } catch (IOException | RuntimeException | LinkageError e) {
      FaultLine.tell(Place.printable(e.toString()), strict);
    }
  }

  /** What comes with the bridge; what lies on CamSim's class path is none of its business. */
  private static Catalogue catalogue() {
    Thread thread = Thread.currentThread();
    ClassLoader before = thread.getContextClassLoader();
    thread.setContextClassLoader(Installer.class.getClassLoader());
    try {
      return Catalogue.load();
    } finally {
      thread.setContextClassLoader(before);
    }
  }

  private static void check(BridgeSettings settings) throws IOException {
    List<String> missing =
        Requirements.missing(settings.uses(), ClassLoader.getSystemClassLoader());
    if (!missing.isEmpty()) {
      throw new InputException("not found in CamSim: " + String.join(", ", missing));
    }
    Optional<Path> out = settings.out();
    if (out.isPresent()) {
      new OutputFolder(out.get()).close();
    }
  }

  private static void install(
      BridgeSettings settings, Instrumentation instrumentation, boolean strict) {
    LiveBridge bridge = new LiveBridge(settings, strict);
    Hooks.connect(bridge);
    Runtime.getRuntime().addShutdownHook(new Thread(bridge::close, "hificamsim-bridge"));
    Weaver.weave(instrumentation, settings.uses(), bridge::fail);
  }
}
