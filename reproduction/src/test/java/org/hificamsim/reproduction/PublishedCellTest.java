package org.hificamsim.reproduction;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class PublishedCellTest {
  @Test
  void tableHasEighteenDifferentCells() {
    List<PublishedCell> table = PublishedCell.table();
    assertEquals(18, table.size());
    assertEquals(
        18,
        table.stream().map(cell -> cell.layout() + cell.policy() + cell.hifi()).distinct().count());
  }

  @Test
  void hiFiColumnHasSumOfTheThesis() {
    double sum =
        PublishedCell.table().stream()
            .filter(PublishedCell::hifi)
            .mapToDouble(PublishedCell::proportion)
            .sum();
    assertEquals(0.50 + 0.92 + 0.60 + 0.61 + 0.94 + 0.73 + 0.44 + 0.93 + 0.70, sum, 1e-12);
  }

  @Test
  void scenariosAreNumberedAsInTable71() {
    assertEquals("cluster-random", Layout.SCENARIOS.get(3 - 1));
    assertEquals("lattice-scripted", Layout.SCENARIOS.get(4 - 1));
  }
}
