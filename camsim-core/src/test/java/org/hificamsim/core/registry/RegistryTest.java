package org.hificamsim.core.registry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class RegistryTest {
  private final Registry<String> registry =
      new Registry<String>("thing")
          .register("plain", "no options", () -> "plain")
          .register("hifi:orb", "a colon", options -> "orb " + options.integer("n", 1, 0, 9, ""))
          .register("hifi:orb:fast", "two", options -> "fast " + options.integer("n", 2, 0, 9, ""));

  @ParameterizedTest
  @CsvSource({
    "plain, plain",
    "hifi:orb, orb 1",
    "hifi:orb:n=5, orb 5",
    "hifi:orb:fast, fast 2",
    "hifi:orb:fast:n=7, fast 7",
  })
  void createsByLongestMatchingName(String spec, String made) {
    assertEquals(made, registry.create(spec));
    assertTrue(registry.knows(spec));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "hifi", "hifi:", "hifi:sift", "Plain", "plain2", ":plain", "plai"})
  void rejectsUnknownNameAndListsKnownOnes(String spec) {
    assertFalse(registry.knows(spec));
    InputException error = assertThrows(InputException.class, () -> registry.create(spec));
    assertEquals(
        "unknown thing '" + spec + "', expected one of plain, hifi:orb, hifi:orb:fast",
        error.getMessage());
  }

  @Test
  void errorReportsEmptyRegistry() {
    Registry<String> empty = new Registry<>("thing");
    InputException error = assertThrows(InputException.class, () -> empty.create("plain"));
    assertEquals(
        "unknown thing 'plain', expected none: no jar on the class path brings one",
        error.getMessage());
  }

  @Test
  void rejectsUnreadOptions() {
    InputException none = assertThrows(InputException.class, () -> registry.create("plain:n=1"));
    assertEquals("thing plain: unknown option 'n=1', expected no options", none.getMessage());
    InputException other =
        assertThrows(InputException.class, () -> registry.create("hifi:orb:m=1"));
    assertEquals("thing hifi:orb: unknown option 'm=1', expected one of n", other.getMessage());
    InputException bare =
        assertThrows(InputException.class, () -> registry.create("hifi:orb:quick"));
    assertEquals("thing hifi:orb: unknown option 'quick', expected one of n", bare.getMessage());
  }

  @Test
  void distinguishesMissingValueFromUnknownOption() {
    InputException bare = assertThrows(InputException.class, () -> registry.create("hifi:orb:n"));
    assertEquals("thing hifi:orb: option 'n' has no value, expected n=VALUE", bare.getMessage());
  }

  @Test
  void createsByAliasWithoutListingIt() {
    assertSame(registry, registry.alias("orb", "hifi:orb"));
    assertEquals("orb 5", registry.create("orb:n=5"));
    assertTrue(registry.knows("orb"));
    assertEquals(List.of("plain", "hifi:orb", "hifi:orb:fast"), registry.names());
    for (List<String> wrong : List.of(List.of("new", "nothing"), List.of("plain", "hifi:orb"))) {
      assertThrows(InputException.class, () -> registry.alias(wrong.get(0), wrong.get(1)));
    }
  }

  @Test
  void rejectsSecondRegistrationOfName() {
    InputException error =
        assertThrows(
            InputException.class, () -> registry.register("plain", "again", () -> "other"));
    assertEquals("thing 'plain' is registered twice, expected each name once", error.getMessage());
    assertEquals("plain", registry.create("plain"), "the first one stays");
  }

  @Test
  void namesKeepOrderOfRegistration() {
    assertEquals(List.of("plain", "hifi:orb", "hifi:orb:fast"), registry.names());
    assertEquals("a colon", registry.entries().get(1).summary());
  }

  @Test
  void readsLateMembersOnceAndOnlyForUnknownNames() {
    List<String> read = new ArrayList<>();
    registry.registerWhenNeeded(
        members -> {
          read.add("late");
          members.register("late", "a late one", () -> "late").alias("later", "late");
        });
    registry.create("plain");
    assertTrue(registry.knows("hifi:orb:n=2"));
    assertEquals(List.of(), read);
    assertEquals("late", registry.create("later"));
    assertEquals(List.of("plain", "hifi:orb", "hifi:orb:fast", "late"), registry.names());
    assertEquals(List.of("late"), read);
  }

  @Test
  void rejectsLateMemberWithTakenName() {
    registry.registerWhenNeeded(members -> members.register("plain", "again", () -> "other"));
    assertThrows(InputException.class, registry::names);
  }

  @Test
  void listsOptionsWithDefaults() {
    assertEquals(List.of(new Options.Declared("n", "1", "")), registry.options("hifi:orb"));
    assertEquals(List.of(), registry.options("plain"));
  }
}
