package org.hificamsim.bridge;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.lang.instrument.ClassFileTransformer;
import java.lang.instrument.IllegalClassFormatException;
import java.lang.instrument.Instrumentation;
import java.lang.reflect.Proxy;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.bridge.agent.Hooks;

/** Runs the doubles of CamSim, with the bridge woven in, in the JVM of the tests. */
final class WovenDoubles extends URLClassLoader {
  /** The system property in which the bridge finds the scenario. */
  private static final String COMMAND = "sun.java.command";

  private final List<ClassFileTransformer> agents = new ArrayList<>();

  private WovenDoubles(String options) throws IOException {
    super(new URL[] {CamSimRun.DOUBLES.toUri().toURL()}, ClassLoader.getPlatformClassLoader());
    if (options != null && !options.isEmpty()) {
      Instrumentation instrumentation =
          (Instrumentation)
              Proxy.newProxyInstance(
                  WovenDoubles.class.getClassLoader(),
                  new Class<?>[] {Instrumentation.class},
                  (proxy, method, arguments) -> agents.add((ClassFileTransformer) arguments[0]));
      new Installer().accept(options, instrumentation);
    }
  }

  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    if (name.startsWith(Hooks.class.getPackageName())) {
      return Class.forName(name);
    }
    String path = name.replace('.', '/');
    try (InputStream in = getResourceAsStream(path + ".class")) {
      byte[] bytes = in.readAllBytes();
      for (ClassFileTransformer agent : agents) {
        byte[] woven = agent.transform(this, path, null, null, bytes);
        bytes = woven == null ? bytes : woven;
      }
      return defineClass(name, bytes, 0, bytes.length);
    } catch (IOException | IllegalClassFormatException e) {
      throw new ClassNotFoundException(name, e);
    }
  }

  /**
   * Runs a scenario for some steps, with seed 0.
   *
   * @param folder where CamSim and the agent write their files
   */
  static CamSimRun run(Path folder, String options, Path scenario, int steps) {
    PrintStream out = System.out;
    PrintStream err = System.err;
    String command = System.getProperty(COMMAND);
    ByteArrayOutputStream newOut = new ByteArrayOutputStream();
    ByteArrayOutputStream newErr = new ByteArrayOutputStream();
    String optionsWithFolder =
        options == null ? null : options.replace("out=", "out=" + folder + "/");
    System.setOut(new PrintStream(newOut, true, StandardCharsets.UTF_8));
    System.setErr(new PrintStream(newErr, true, StandardCharsets.UTF_8));
    System.setProperty(COMMAND, "epics.camwin.Main " + scenario);
    Object arguments =
        new String[] {"-t", "" + steps, "-o", "" + folder.resolve("output.csv"), "" + scenario};
    try {
      Files.createDirectories(folder);
      try (WovenDoubles doubles = new WovenDoubles(optionsWithFolder)) {
        doubles
            .loadClass("epics.camwin.Main")
            .getMethod("main", String[].class)
            .invoke(null, arguments);
      }
    } catch (IOException | ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    } finally {
      System.setOut(out);
      System.setErr(err);
      System.setProperty(COMMAND, command);
    }
    return new CamSimRun(
        0,
        newOut.toString(StandardCharsets.UTF_8),
        newErr.toString(StandardCharsets.UTF_8),
        folder);
  }
}
