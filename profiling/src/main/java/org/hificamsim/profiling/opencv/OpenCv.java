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

  private OpenCv() {}

  /**
   * Loads the library where that has not been done.
   *
   * @throws OpenCvMissingException in one line, when there is none that loads
   */
  public static void load() {
    Loaded.check();
  }

  /** Where the library came from, for the record of a run. */
  public static String origin() {
    Loaded.check();
    return Loaded.RESULT.origin();
  }

  /** Which OpenCV this is, as in {@code 4.6.0 (org.openpnp:opencv)}. */
  public static String version() {
    return Core.VERSION + " (" + origin() + ")";
  }

  /** One way to load the library. */
  interface Way {
    void load() throws Exception;
  }

  /** A way to load and what to call it. */
  record Source(String name, Way way) {}

  /** The outcome of trying the sources: where it came from, or why there is none. */
  record Result(String origin, String failure) {}

  /** Tries one source after the other. */
  static Result firstThatLoads(List<Source> sources) {
    List<String> reasons = new ArrayList<>();
    for (Source source : sources) {
      try {
        source.way().load();
        return new Result(source.name(), null);
      } catch (Exception | LinkageError e) {
        reasons.add(source.name() + ": " + oneLine(e));
      }
    }
    return new Result(null, String.join("; ", reasons));
  }

  private static List<Source> sources() {
    String file = System.mapLibraryName(Core.NATIVE_LIBRARY_NAME);
    return List.of(
        new Source("Debian's libopencv-java", () -> System.load(existing(DEBIAN.resolve(file)))),
        new Source("org.openpnp:opencv", OpenCv::loadFromJar),
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
    String message = cause instanceof ClassNotFoundException ? "not in this build" : null;
    message = message == null ? String.valueOf(cause.getMessage()) : message;
    return message.lines().findFirst().orElse(cause.getClass().getSimpleName());
  }

  private static final class Loaded {
    static final Result RESULT = loadAndSetUp();

    static void check() {
      if (RESULT.failure() != null) {
        throw new OpenCvMissingException(RESULT.failure());
      }
    }

    private static Result loadAndSetUp() {
      try {
        Result result = firstThatLoads(sources());
        if (result.failure() == null) {
          // The work is spread over images; one thread each keeps results and memory the same.
          Core.setNumThreads(1);
        }
        return result;
      } catch (NoClassDefFoundError e) {
        return new Result(null, "its classes are not on the class path");
      }
    }
  }
}
