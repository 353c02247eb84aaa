package org.hificamsim.agents.cooperative;

/**
 * Ways of a camera through its views: by step, the view through which it sees, or the complement
 * {@code ~view} of the view that it is on its way to.
 */
final class Ways {
  private Ways() {}

  /** The view that a camera chooses first. */
  static int goal(int[] way) {
    return goal(way, 0);
  }

  /** The view that a camera has in a step, or is on its way to. */
  static int goal(int[] way, int step) {
    return way[step] >= 0 ? way[step] : ~way[step];
  }

  /** Whether a camera sees in a step, through a view that it did not have before. */
  static boolean isFirstLook(int[] way, int step) {
    boolean first = way[step] >= 0;
    for (int before = 0; before < step && first; before++) {
      first = way[before] != way[step];
    }
    return first;
  }

  /**
   * Fills in how a way continues some steps later; at its end the camera stays.
   *
   * @param views number of views that the camera has now
   */
  static void after(int[] way, long steps, int views, int[] continuedWay) {
    for (int step = 0; step < continuedWay.length; step++) {
      long before = step + steps;
      int view = before < way.length ? way[(int) before] : goal(way, way.length - 1);
      continuedWay[step] = view >= 0 ? Math.min(view, views - 1) : Math.max(view, ~(views - 1));
    }
  }
}
