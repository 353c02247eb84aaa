package org.hificamsim.profiling.detector;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;

class MemoryTest {
  private static final long MEGAPIXEL = 1_000_000;
  private static final Memory SIFT = new Memory(250, 0);

  private final Memory free = new Memory(10e9, 4e9);

  @Test
  void limitsThreadsToPhotosThatFit() {
    assertEquals(8, free.threads(8, MEGAPIXEL, SIFT));
    assertEquals(1, free.threads(8, 18 * MEGAPIXEL, SIFT));
    assertEquals(3, free.threads(8, 10 * MEGAPIXEL, SIFT));
    assertEquals(3, free.threads(8, 20 * MEGAPIXEL, new Memory(2, 50)));
  }

  @Test
  void rejectsPhotosLargerThanTheMemory() {
    String message =
        assertThrows(InputException.class, () -> free.threads(2, 48 * MEGAPIXEL, SIFT))
            .getMessage();
    assertTrue(message.contains("48.0 megapixels need about 11.2 GiB"), message);
  }

  @Test
  void smallPhotoFitsIntoFreeMemory() {
    assertEquals(1, Memory.free().threads(1, MEGAPIXEL / 100, SIFT));
  }
}
