package org.hificamsim.cli;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;

import org.junit.jupiter.api.Test;

class HeadStartTest {
  @Test
  void everyPartCanBeUsedBeforeARun() {
    assertDoesNotThrow(HeadStart::load);
  }
}
