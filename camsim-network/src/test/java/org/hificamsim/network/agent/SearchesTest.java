package org.hificamsim.network.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

/** Compares searches with a model that has one map per camera. */
class SearchesTest {
  private static final int CAMERAS = 4;
  private static final int TARGETS = 3;

  private final Random random = new Random(1);
  private final World world =
      new TestScenario().camera(0, 0).camera(1, 0).camera(2, 0).camera(3, 0).world();
  private final Searches searches = new Searches(world.cameras(), TARGETS);
  private final List<Map<Integer, Integer>> model = new ArrayList<>();

  @Test
  void searchesMatchOneMapPerCamera() {
    for (int camera = 0; camera < CAMERAS; camera++) {
      model.add(new LinkedHashMap<>());
    }
    for (int i = 0; i < 100_000; i++) {
      act(random.nextInt(40), random.nextInt(CAMERAS), random.nextInt(TARGETS));
      for (int camera = 0; camera < CAMERAS; camera++) {
        assertSame(camera);
      }
    }
  }

  private void act(int action, int camera, int target) {
    if (action == 0) {
      world.switchCamera(camera, !world.cameras().online(camera));
    } else if (action < 10) {
      int searcher = random.nextInt(Searches.NOBODY, CAMERAS);
      searches.begin(camera, target, searcher);
      model.get(camera).put(target, searcher);
    } else if (action < 15) {
      searches.end(camera, target);
      model.get(camera).remove(target);
    } else {
      receiveAll(action < 30 ? MessageKind.START_SEARCH : MessageKind.STOP_SEARCH, camera, target);
    }
  }

  private void receiveAll(MessageKind kind, int from, int target) {
    int receivers = 0;
    for (int camera = 0; camera < CAMERAS; camera++) {
      if (camera != from && world.cameras().online(camera)) {
        receivers++;
        if (kind == MessageKind.START_SEARCH) {
          model.get(camera).put(target, from);
        } else {
          model.get(camera).remove(target);
        }
      }
    }
    assertEquals(receivers, searches.receiveAll(kind, from, target));
  }

  private static final double[] RANDOM_FEATURES = new Random(7).doubles(TARGETS).toArray();

  private void assertSame(int camera) {
    List<Integer> owned = new ArrayList<>();
    for (int target = 0; target < TARGETS; target++) {
      owned.add(random.nextInt(owned.size() + 1), target);
      int expected = model.get(camera).getOrDefault(target, Searches.NONE);
      assertEquals(expected, searches.searcher(camera, target));
    }
    List<Integer> expectedOrder = new ArrayList<>(model.get(camera).keySet());
    expectedOrder.removeIf(target -> model.get(camera).get(target) != camera);
    OwnedTargets ownedTargets = new OwnedTargets(new TargetKeys(RANDOM_FEATURES));
    owned.forEach(ownedTargets::add);
    int[] ownSearches = searches.ownSearches(camera, ownedTargets);
    assertEquals(expectedOrder, IntStream.of(ownSearches).boxed().toList());
  }
}
