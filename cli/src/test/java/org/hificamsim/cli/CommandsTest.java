package org.hificamsim.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that a call loads only the commands that it needs. */
class CommandsTest {
  private static final Set<String> ALL = Commands.all().getSubcommands().keySet();

  private static Set<String> names() {
    Set<String> names = new TreeSet<>(ALL);
    names.removeAll(Set.of("help", "generate-completion"));
    return names;
  }

  @ParameterizedTest
  @MethodSource("names")
  void loadsOnlyTheNamedCommand(String name) {
    assertEquals(Set.of(name), Commands.line(name).getSubcommands().keySet());
  }

  @ParameterizedTest
  @ValueSource(strings = {"help", "generate-completion", "--help", "CAMSIM", "unknown"})
  void loadsAllCommandsForAnyOtherWord(String word) {
    assertEquals(ALL, Commands.line(word).getSubcommands().keySet());
  }
}
