package org.hificamsim.profiling.opencv;

import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.opencv.core.Core;

/**
 * Loads OpenCV's native library once: the one inside the jar from Maven Central, else Debian's,
 * else the first on Java's library path.
 */
public final class OpenCv {
  private static final Path DEBIAN = Path.of("/usr/lib/jni");
  private static String origin;

  private OpenCv() {}

  /** Reports in one line that OpenCV does not load, and how to install it. */
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
   * Loads the library unless it is loaded already.
   *
   * @throws OpenCvMissingException when no library loads
   */
  public static synchronized void load() {
    if (origin == null) {
      try {
        origin = loadFirst(sources());
      } catch (NoClassDefFoundError e) {
        throw new OpenCvMissingException("its classes are not on the class path");
      }
      // Images are processed in parallel; one thread for each keeps results and memory constant.
      Core.setNumThreads(1);
    }
  }

  /** Returns the version and source of OpenCV, as in {@code 4.6.0 (org.openpnp:opencv)}. */
  public static synchronized String version() {
    load();
    return Core.VERSION + " (" + origin + ")";
  }

  /** A way to load the library. */
  interface Loader {
    void load() throws Exception;
  }

  /** A source of the library, by its name in messages. */
  record Source(String name, Loader loader) {}

  /** Tries one source after the other; returns the name of the first that loads. */
  static String loadFirst(List<Source> sources) {
    List<String> reasons = new ArrayList<>();
    for (Source source : sources) {
      try {
        source.loader().load();
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
        new Source(
            "Debian's libopencv-java", () -> System.load(requireExists(DEBIAN.resolve(file)))),
        new Source("java.library.path", () -> System.loadLibrary(Core.NATIVE_LIBRARY_NAME)));
  }

  private static String requireExists(Path library) {
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
