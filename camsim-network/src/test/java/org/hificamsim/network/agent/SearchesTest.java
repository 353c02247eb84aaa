package org.hificamsim.network.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

/** What cameras look for is as if each of them kept a map of its own. */
class SearchesTest {
  private static final int CAMERAS = 4;
  private static final int TARGETS = 3;

  private final Random random = new Random(1);
  private final World world =
      new TestScenario().camera(0, 0).camera(1, 0).camera(2, 0).camera(3, 0).world();
  private final Searches searches = new Searches(world.cameras(), TARGETS);
  private final List<Map<Integer, Integer>> plain = new ArrayList<>();

  @Test
  void eachCameraLooksForWhatItsOwnMapWouldSayInTheSameOrder() {
    for (int camera = 0; camera < CAMERAS; camera++) {
      plain.add(new LinkedHashMap<>());
    }
    for (int i = 0; i < 100_000; i++) {
      act(random.nextInt(40), random.nextInt(CAMERAS), random.nextInt(TARGETS));
      for (int camera = 0; camera < CAMERAS; camera++) {
        assertSame(camera);
      }
    }
  }

  private void act(int what, int camera, int target) {
    if (what == 0) {
      world.switchCamera(camera, !world.cameras().online(camera));
    } else if (what < 10) {
      int searcher = random.nextInt(Searches.NOBODY, CAMERAS);
      searches.begin(camera, target, searcher);
      plain.get(camera).put(target, searcher);
    } else if (what < 15) {
      searches.end(camera, target);
      plain.get(camera).remove(target);
    } else {
      tellAll(what < 30 ? MessageKind.START_SEARCH : MessageKind.STOP_SEARCH, camera, target);
    }
  }

  private void tellAll(MessageKind kind, int from, int target) {
    int receivers = 0;
    for (int camera = 0; camera < CAMERAS; camera++) {
      if (camera != from && world.cameras().online(camera)) {
        receivers++;
        if (kind == MessageKind.START_SEARCH) {
          plain.get(camera).put(target, from);
        } else {
          plain.get(camera).remove(target);
        }
      }
    }
    assertEquals(receivers, searches.receiveAll(kind, from, target));
  }

  private void assertSame(int camera) {
    List<Integer> owned = new ArrayList<>();
    for (int target = 0; target < TARGETS; target++) {
      owned.add(random.nextInt(owned.size() + 1), target);
      int expected = plain.get(camera).getOrDefault(target, Searches.NONE);
      assertEquals(expected, searches.searcher(camera, target));
    }
    List<Integer> own = new ArrayList<>(plain.get(camera).keySet());
    own.removeIf(target -> plain.get(camera).get(target) != camera);
    assertEquals(own, searches.own(camera, owned));
  }
}
