package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.NamedSetting;
import org.hificamsim.tracks.format.KnownFormat;
import org.junit.jupiter.api.Test;

/** Tests that the documentation of the formats of recordings agrees with their declarations. */
class FormatTableTest {
  private static final NamedSetting.Notation FLAGS =
      new NamedSetting.Notation() {
        @Override
        public String name(String setting) {
          return "--" + setting.replace('_', '-');
        }

        @Override
        public String assignment(String setting, String value) {
          return name(setting) + " " + value;
        }
      };

  @Test
  void everyFormatIsDocumentedAsDeclared() throws IOException {
    List<String> page = Files.readAllLines(Cli.ROOT.resolve("docs/tracks.md"));
    int header = page.indexOf("| `--format` | line or element | time | positions |");
    List<String> table =
        page.stream().skip(header + 2).takeWhile(line -> line.startsWith("|")).toList();
    List<String> declared = KnownFormat.all().stream().map(format -> format.row(FLAGS)).toList();
    assertEquals(String.join("\n", declared), String.join("\n", table));
  }

  @Test
  void helpNamesEveryFormat() throws IOException {
    String help =
        Files.readString(
            Cli.ROOT.resolve(
                Path.of("cli/src/main/resources/org/hificamsim/cli/options.properties")));
    String line =
        help.lines().filter(text -> text.startsWith("hificamsim.import.format =")).findAny().get();
    KnownFormat.all()
        .forEach(format -> assertTrue(line.contains(" " + format.name()), format.name()));
  }
}
