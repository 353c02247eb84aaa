package org.hificamsim.solver;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class ExchangeTest {
  /** Each chooser may be one more than the one before it. */
  private static class Stairs implements Exchange.Choice {
    protected final int[] heights = new int[4];
    protected int passes;

    @Override
    public int choosers() {
      passes++;
      return heights.length;
    }

    @Override
    public boolean exchange(int chooser) {
      int before = heights[chooser];
      boolean last = chooser == heights.length - 1;
      heights[chooser] = last ? 1 : heights[chooser + 1] + 1;
      return heights[chooser] > before;
    }
  }

  @Test
  void makesPassesUntilNoChooserImproves() {
    Stairs stairs = new Stairs();
    Exchange.improve(stairs, Exchange.UNLIMITED);
    assertArrayEquals(new int[] {4, 3, 2, 1}, stairs.heights);
    assertEquals(5, stairs.passes);
  }

  @Test
  void endsAfterGreatestNumberOfPasses() {
    Stairs stairs = new Stairs();
    Exchange.improve(stairs, 2);
    assertArrayEquals(new int[] {2, 2, 2, 1}, stairs.heights);
    assertEquals(2, stairs.passes);
  }

  @Test
  void choiceMayEndPassesByItself() {
    Stairs stairs =
        new Stairs() {
          @Override
          public boolean endPass(boolean improved) {
            return heights[0] < 3;
          }
        };
    Exchange.improve(stairs, Exchange.UNLIMITED);
    assertEquals(3, stairs.passes);
  }
}
