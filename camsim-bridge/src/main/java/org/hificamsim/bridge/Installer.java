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
 * Installs the bridge. It reads the options, checks that this CamSim has the methods that they
 * need, and registers the weaver that inserts hooks into its classes. If a check fails, it installs
 * nothing.
 */
public final class Installer implements BiConsumer<String, Instrumentation> {
  @Override
  public void accept(String options, Instrumentation instrumentation) {
    boolean strict = FaultLine.isStrict(options);
    try {
      BridgeSettings settings = BridgeOptions.parse(options, catalogue());
      if (settings.needsWeaving()) {
        check(settings);
        install(settings, instrumentation, strict);
      }
    } catch (InputException e) {
      FaultLine.report(Place.printable(e.getMessage()), strict);
    } catch (IOException | RuntimeException | LinkageError e) {
      FaultLine.report(Place.printable(e.toString()), strict);
    }
  }

  /** Loads the catalogue of the bridge, without extensions on the class path of CamSim. */
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
