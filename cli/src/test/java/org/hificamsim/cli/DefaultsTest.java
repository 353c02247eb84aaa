package org.hificamsim.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.ResourceBundle;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** Tests that {@code options.properties} and the options of the commands agree. */
class DefaultsTest {
  private final ResourceBundle texts = Main.options();
  private final Properties defaults = Main.defaults(texts);
  private final List<OptionSpec> options = new ArrayList<>();

  @BeforeEach
  void readBoth() {
    collect(Commands.all());
    assertTrue(options.size() > 100, options.size() + " options");
  }

  @Test
  void everyDefaultAndTextBelongsToOption() {
    Set<String> unknown = new TreeSet<>(defaults.stringPropertyNames());
    texts.keySet().stream()
        .map(key -> key.replaceFirst("\\.(default|\\d)$", ""))
        .forEach(unknown::add);
    options.forEach(option -> unknown.removeAll(List.of(qualified(option), plain(option))));
    assertEquals(Set.of(), unknown);
  }

  @Test
  void everyPrimitiveOptionHasDefault() {
    for (OptionSpec option : options) {
      assertTrue(
          option.arity().max() == 0
              || !option.type().isPrimitive()
              || defaults.containsKey(qualified(option))
              || defaults.containsKey(plain(option))
              || option.defaultValue() != null,
          qualified(option));
    }
  }

  @Test
  void everyOptionHasText() {
    CommandLine all = Commands.all().setResourceBundle(texts);
    options.clear();
    collect(all);
    options.forEach(option -> assertTrue(option.description().length > 0, qualified(option)));
  }

  private void collect(CommandLine command) {
    options.addAll(command.getCommandSpec().options());
    command.getSubcommands().values().forEach(this::collect);
  }

  private static String qualified(OptionSpec option) {
    return option.command().qualifiedName(".") + "." + plain(option);
  }

  private static String plain(OptionSpec option) {
    return option.longestName().replaceFirst("^-+", "");
  }
}
