package org.hificamsim.profiling.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.core.InputException;
import org.hificamsim.profiling.detector.MemoryNeed;
import org.junit.jupiter.api.Test;

class MemoryBudgetTest {
  private static final long MEGAPIXEL = 1_000_000;
  private static final MemoryNeed SIFT = new MemoryNeed(250, 0);

  private final MemoryBudget budget = new MemoryBudget(10e9, 4e9);

  @Test
  void asManyThreadsAsPhotosFitIntoTheMemory() {
    assertEquals(8, budget.threads(8, MEGAPIXEL, SIFT));
    assertEquals(1, budget.threads(8, 18 * MEGAPIXEL, SIFT));
    assertEquals(3, budget.threads(8, 10 * MEGAPIXEL, SIFT));
    assertEquals(3, budget.threads(8, 20 * MEGAPIXEL, new MemoryNeed(2, 50)));
  }

  @Test
  void photosThatDoNotFitOnceAreRefusedWithWhatTheyNeed() {
    String message =
        assertThrows(InputException.class, () -> budget.threads(2, 48 * MEGAPIXEL, SIFT))
            .getMessage();
    assertTrue(message.contains("48.0 megapixels need about 11.2 GiB"), message);
  }

  @Test
  void thisMachineHasRoomForASmallPhoto() {
    assertEquals(1, MemoryBudget.now().threads(1, MEGAPIXEL / 100, SIFT));
  }
}
