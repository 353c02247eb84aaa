package org.hificamsim.acceptance;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.cli.Main;

/**
 * What one command of the command line did.
 *
 * @param exit its exit code
 */
record Cli(int exit, String out, String err) {
  /** The project's root. */
  static final Path ROOT = Path.of(System.getProperty("hificamsim.root", "."));

  /** The scenarios of Table 7.1, by name. */
  static final List<String> SIX =
      Stream.of("lattice", "ring", "cluster")
          .flatMap(layout -> Stream.of(layout + "-random", layout + "-scripted"))
          .toList();

  /** Runs a command in this process. */
  static Cli run(Object... words) {
    StringWriter out = new StringWriter();
    StringWriter err = new StringWriter();
    String[] args = Arrays.stream(words).map(Object::toString).toArray(String[]::new);
    int exit = Main.execute(new PrintWriter(out, true), new PrintWriter(err, true), args);
    return new Cli(exit, out.toString(), err.toString());
  }

  /** A scenario of the project. */
  static Path scenario(String name) {
    return ROOT.resolve("scenarios").resolve(name + ".xml");
  }

  /** The reference data; may be missing. */
  static Path reference(String name) {
    return ROOT.resolve("../shared/reference").resolve(name).normalize();
  }
}
