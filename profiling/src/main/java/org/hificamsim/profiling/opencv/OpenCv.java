package org.hificamsim.profiling.opencv;

import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.opencv.core.Core;

/**
 * OpenCV's native library, loaded once: Debian's where it is installed in the version that the
 * classes ask for, else the one inside the jar from Maven Central, else the first on Java's library
 * path.
 */
public final class OpenCv {
  private static final Path DEBIAN = Path.of("/usr/lib/jni");
  private static String origin;

  private OpenCv() {}

  /** Reported in one line, with what helps. */
  static final class OpenCvMissingException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    OpenCvMissingException(String reasons) {
      super(
          "OpenCV does not load, expected Debian's libopencv-java or org.openpnp:opencv for this"
              + " machine ("
              + reasons
              + "). Maybe install libopencv-java and build again");
    }
  }

  /**
   * Loads the library where that has not been done.
   *
   * @throws OpenCvMissingException when there is none that loads
   */
  public static synchronized void load() {
    if (origin == null) {
      try {
        origin = firstThatLoads(sources());
      } catch (NoClassDefFoundError e) {
        throw new OpenCvMissingException("its classes are not on the class path");
      }
      // The work is spread over images; one thread each keeps results and memory the same.
      Core.setNumThreads(1);
    }
  }

  /** Which OpenCV this is and where it came from, as in {@code 4.6.0 (org.openpnp:opencv)}. */
  public static synchronized String version() {
    load();
    return Core.VERSION + " (" + origin + ")";
  }

  /** One way to load the library. */
  interface Way {
    void load() throws Exception;
  }

  /** A way to load and what to call it. */
  record Source(String name, Way way) {}

  /** Tries one source after the other; the name of the one that loads. */
  static String firstThatLoads(List<Source> sources) {
    List<String> reasons = new ArrayList<>();
    for (Source source : sources) {
      try {
        source.way().load();
        return source.name();
      } catch (Exception | LinkageError e) {
        reasons.add(source.name() + ": " + oneLine(e));
      }
    }
    throw new OpenCvMissingException(String.join("; ", reasons));
  }

  private static List<Source> sources() {
    String file = System.mapLibraryName(Core.NATIVE_LIBRARY_NAME);
    return List.of(
        new Source("org.openpnp:opencv", OpenCv::loadFromJar),
        new Source("Debian's libopencv-java", () -> System.load(existing(DEBIAN.resolve(file)))),
        new Source("java.library.path", () -> System.loadLibrary(Core.NATIVE_LIBRARY_NAME)));
  }

  private static String existing(Path library) {
    if (!Files.exists(library)) {
      throw new IllegalStateException("no " + library);
    }
    return library.toString();
  }

  private static void loadFromJar() throws ReflectiveOperationException {
    Class.forName("nu.pattern.OpenCV").getMethod("loadLocally").invoke(null);
  }

  private static String oneLine(Throwable e) {
    Throwable cause =
        e instanceof InvocationTargetException && e.getCause() != null ? e.getCause() : e;
    if (cause instanceof ClassNotFoundException) {
      return "not in this build";
    }
    String message = String.valueOf(cause.getMessage());
    return message.lines().findFirst().orElse(cause.getClass().getSimpleName());
  }
}
