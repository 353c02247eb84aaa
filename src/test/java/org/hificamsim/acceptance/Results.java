package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The results of a long command, for tests that only read them: each command runs once for all
 * tests.
 *
 * @param cli the outcome of the command
 * @param folder the folder of the results, which is deleted when this process ends
 */
record Results(Cli cli, Path folder) {
  private static final Map<List<String>, Results> MADE = new HashMap<>();

  /**
   * Returns the results of a command, which is run unless a test has run it before.
   *
   * @param words the command and its arguments except {@code --out}
   */
  static synchronized Results of(Object... words) {
    return MADE.computeIfAbsent(
        Arrays.stream(words).map(Object::toString).toList(),
        key -> untilTheEnd("results", folder -> make(folder, words), results -> {}));
  }

  private static Results make(Path folder, Object... words) {
    Cli cli = Cli.run(Stream.concat(Arrays.stream(words), Stream.of("--out", folder)).toArray());
    assertEquals(0, cli.exit(), cli.err());
    return new Results(cli, folder);
  }

  /**
   * Makes something in a new folder. When this process ends, it is closed and the folder is
   * deleted.
   */
  static <T> T untilTheEnd(String name, Function<Path, T> make, Consumer<T> close) {
    try {
      Path folder = Files.createTempDirectory(name);
      T made = make.apply(folder);
      Runtime.getRuntime()
          .addShutdownHook(
              new Thread(
                  () -> {
                    close.accept(made);
                    delete(folder);
                  }));
      return made;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void delete(Path folder) {
    try (Stream<Path> all = Files.walk(folder)) {
      all.sorted(Comparator.reverseOrder()).map(Path::toFile).forEach(java.io.File::delete);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
