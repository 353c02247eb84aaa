import com.caoccao.javet.exceptions.JavetException;
import com.caoccao.javet.interop.V8Host;
import com.caoccao.javet.interop.V8Runtime;
import com.caoccao.javet.values.reference.V8ValueGlobalObject;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Formats JavaScript files with Prettier, which V8 runs inside the JVM.
 *
 * <p>The arguments are {@code check} or {@code write}, Prettier's folder on the class path, the
 * file with its options, and the scripts. {@code check} changes nothing and names each file that
 * has another format. The exit code is 1 if there is such a file, or a line that is too long.
 */
public final class FormatScripts {
  private static final int LONGEST_LINE = 100;

  private final V8Runtime engine;
  private final String options;

  private FormatScripts(V8Runtime engine, String options) {
    this.engine = engine;
    this.options = options;
  }

  public static void main(String[] arguments) throws IOException, JavetException {
    boolean write = arguments[0].equals("write");
    List<Path> scripts = Arrays.stream(arguments).skip(3).map(Path::of).sorted().toList();
    List<String> faults = new ArrayList<>();
    try (V8Runtime engine = V8Host.getV8Instance().createV8Runtime()) {
      for (String name : List.of("standalone.js", "plugins/estree.js", "plugins/babel.js")) {
        engine.getExecutor(resource(arguments[1] + "/" + name)).executeVoid();
      }
      FormatScripts formatter = new FormatScripts(engine, Files.readString(Path.of(arguments[2])));
      for (Path script : scripts) {
        String source = Files.readString(script);
        String formatted = formatter.format(script, source);
        if (write && !formatted.equals(source)) {
          Files.writeString(script, formatted);
        } else if (!formatted.equals(source)) {
          faults.add(script + " has another format; `gradle format` rewrites it");
        }
        faults.addAll(longLines(script, formatted));
      }
    }
    faults.forEach(System.err::println);
    System.exit(faults.isEmpty() ? 0 : 1);
  }

  /**
   * Returns messages about long lines that Prettier cannot break: comments, texts and templates.
   */
  private static List<String> longLines(Path script, String formatted) {
    List<String> lines = formatted.lines().toList();
    return IntStream.range(0, lines.size())
        .filter(index -> lines.get(index).length() > LONGEST_LINE)
        .mapToObj(
            index ->
                "%s:%d has %d characters, expected at most %d"
                    .formatted(script, index + 1, lines.get(index).length(), LONGEST_LINE))
        .toList();
  }

  private static String resource(String name) throws IOException {
    try (InputStream stream = FormatScripts.class.getResourceAsStream(name)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private String format(Path script, String source) throws JavetException {
    V8ValueGlobalObject global = engine.getGlobalObject();
    global.set("source", source);
    global.delete("formatted");
    engine
        .getExecutor(
            """
prettier
  .format(source, {...%s, parser: 'babel', plugins: Object.values(prettierPlugins)})
  .then(text => (globalThis.formatted = text), error => (globalThis.failure = String(error)))
"""
                .formatted(options))
        .executeVoid();
    engine.await();
    String formatted = global.getString("formatted");
    if (formatted == null) {
      throw new IllegalArgumentException(script + ": " + global.getString("failure"));
    }
    return formatted;
  }
}
