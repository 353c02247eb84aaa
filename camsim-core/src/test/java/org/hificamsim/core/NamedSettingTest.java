package org.hificamsim.core;

import static org.hificamsim.core.NamedSetting.setting;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class NamedSettingTest {
  private static final NamedSetting.Notation FLAGS =
      new NamedSetting.Notation() {
        @Override
        public String name(String setting) {
          return "--" + setting;
        }

        @Override
        public String assignment(String setting, String value) {
          return name(setting) + " " + value;
        }
      };

  @Test
  void messageHasPlainNamesUnlessNotationIsGiven() {
    InputException fault =
        InputException.of("%s is %s, expected %s", setting("steps"), 0, setting("method", "exact"));
    assertEquals("steps is 0, expected method=exact", fault.getMessage());
    assertEquals("--steps is 0, expected --method exact", fault.message(FLAGS));
  }

  @Test
  void errorAtPlaceKeepsSettingsOfMessage() {
    InputException fault =
        new Place("a.csv", 3, 1).error("no column 'x', maybe " + setting("columns"));
    assertEquals("a.csv:3:1: no column 'x', maybe columns", fault.getMessage());
    assertEquals("a.csv:3:1: no column 'x', maybe --columns", fault.message(FLAGS));
  }

  @Test
  void acceptsRegexCharactersInValues() {
    InputException fault = InputException.of("expected %s", setting("unit", "$1\\"));
    assertEquals("expected --unit $1\\", fault.message(FLAGS));
  }
}
