package org.hificamsim.reproduction;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class PublishedTest {
  @Test
  void theTableHasEighteenCellsEachOnce() {
    List<Published> table = Published.table();
    assertEquals(18, table.size());
    assertEquals(
        18,
        table.stream().map(cell -> cell.layout() + cell.policy() + cell.hifi()).distinct().count());
  }

  @Test
  void theHiFiColumnSumsToThatOfTheThesis() {
    double sum =
        Published.table().stream().filter(Published::hifi).mapToDouble(Published::proportion).sum();
    assertEquals(0.50 + 0.92 + 0.60 + 0.61 + 0.94 + 0.73 + 0.44 + 0.93 + 0.70, sum, 1e-12);
  }

  @Test
  void scenariosAreNumberedAsInTable71() {
    assertEquals("cluster-random", Layout.SCENARIOS.get(3 - 1));
    assertEquals("lattice-scripted", Layout.SCENARIOS.get(4 - 1));
  }
}
