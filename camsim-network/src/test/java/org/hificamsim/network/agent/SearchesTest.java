package org.hificamsim.network.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Cameras that hear the same are as those of which each keeps a map of its own. */
class SearchesTest {
  private static final int CAMERAS = 4;
  private static final int TARGETS = 3;

  private final Random random = new Random(1);
  private final SharedSearches shared = new SharedSearches(TARGETS);
  private final List<Searches> cameras = new ArrayList<>();
  private final List<Map<Integer, Integer>> plain = new ArrayList<>();
  private final boolean[] online = new boolean[CAMERAS];
  private int heardByAll;

  @Test
  void eachCameraLooksForWhatItsOwnMapWouldSayInTheSameOrder() {
    for (int camera = 0; camera < CAMERAS; camera++) {
      add();
    }
    for (int i = 0; i < 100_000; i++) {
      act(random.nextInt(CAMERAS), random.nextInt(TARGETS));
      for (int camera = 0; camera < CAMERAS; camera++) {
        assertSame(camera);
      }
    }
    assertTrue(heardByAll > 10_000, heardByAll + " were written down once for all");
  }

  @Test
  void aCameraThatIsAddedLooksForNothing() {
    add();
    add();
    start(0, 1);
    add();
    assertTrue(cameras.get(1).contains(1));
    assertSame(2);
    start(0, 1);
    assertSame(2);
  }

  private void add() {
    int camera = cameras.size();
    online[camera] = true;
    cameras.add(new Searches(camera, shared, TARGETS));
    plain.add(new LinkedHashMap<>());
  }

  private void act(int camera, int target) {
    int what = random.nextInt(40);
    if (what == 0) {
      online[camera] = !online[camera];
      cameras.get(camera).listen(online[camera]);
    } else if (online[camera]) {
      act(what, camera, target);
    }
  }

  private void act(int what, int camera, int target) {
    if (what < 15) {
      start(camera, target);
    } else if (what < 35) {
      stop(camera, target);
    } else if (what < 37) {
      cameras.get(camera).put(target, Searches.NOBODY);
      plain.get(camera).put(target, Searches.NOBODY);
    } else {
      cameras.get(camera).remove(target);
      plain.get(camera).remove(target);
    }
  }

  /** A camera advertises a target to all that are online, or sometimes to one. */
  private void start(int camera, int target) {
    cameras.get(camera).put(target, camera);
    plain.get(camera).put(target, camera);
    long time = cameras.get(camera).changed(target);
    boolean toAll = random.nextInt(10) > 0;
    boolean heard = toAll && shared.start(target, cameras.get(camera), time);
    heardByAll += heard ? 1 : 0;
    for (int other = 0; other < cameras.size(); other++) {
      if (other != camera && online[other] && (toAll || other == (camera + 1) % CAMERAS)) {
        plain.get(other).put(target, camera);
        if (!heard) {
          cameras.get(other).hear(target, camera, time);
        }
      }
    }
  }

  private void stop(int camera, int target) {
    cameras.get(camera).remove(target);
    plain.get(camera).remove(target);
    assertTrue(shared.stop(target, cameras.get(camera)));
    for (int other = 0; other < cameras.size(); other++) {
      if (online[other]) {
        plain.get(other).remove(target);
      }
    }
  }

  private void assertSame(int camera) {
    Searches searches = cameras.get(camera);
    for (int target = 0; target < TARGETS; target++) {
      int expected = plain.get(camera).getOrDefault(target, Searches.NONE);
      assertEquals(expected, searches.searcher(target));
      assertEquals(expected != Searches.NONE, searches.contains(target));
    }
    List<Integer> own = new ArrayList<>(plain.get(camera).keySet());
    own.removeIf(target -> plain.get(camera).get(target) != camera);
    assertEquals(own.size(), searches.findOwn());
    for (int i = 0; i < own.size(); i++) {
      assertEquals(own.get(i), searches.own(i));
    }
  }
}
