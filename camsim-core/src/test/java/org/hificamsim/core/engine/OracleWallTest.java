package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.Array;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.metrics.CoverableTargets;
import org.hificamsim.core.metrics.DetectionChances;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.OraclePolicy;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;

/**
 * Tests that a policy cannot reach the truth from its view. It visits all objects that can be
 * reached: through the public methods of all public types that the view can be cast to, and of
 * their results. {@code setAccessible} is out of scope.
 */
class OracleWallTest {
  private static final List<Class<?>> ORACLES =
      List.of(
          OracleView.class,
          DetectionChances.class,
          CoverableTargets.class,
          World.class,
          Targets.class,
          Simulation.class,
          Sight.class);

  /** Keeps its views. */
  private static class Keeping implements ZoomPolicy {
    final Set<NetworkView> receivedViews = Collections.newSetFromMap(new IdentityHashMap<>());

    @Override
    public String name() {
      return "keeping";
    }

    @Override
    public void begin(NetworkView network, SplittableRandom random) {
      receivedViews.add(network);
    }

    @Override
    public void decide(NetworkView network, int[] views) {
      receivedViews.add(network);
    }

    @Override
    public void learn(NetworkView network) {
      receivedViews.add(network);
    }
  }

  /** Keeps its views, as a bound. */
  private static final class KeepingBound extends Keeping implements OraclePolicy {
    @Override
    public void decide(OracleView network, int[] views) {
      receivedViews.add(network);
    }
  }

  @Test
  void deployablePoliciesCannotReachTheOracle() {
    Keeping policy = new Keeping();
    run(policy);
    assertEquals(1, policy.receivedViews.size(), "one view for the whole run");
    Walk walk = new Walk();
    walk.from(policy.receivedViews.iterator().next());
    assertEquals(List.of(), walk.found);
    assertTrue(walk.calls > 40, walk.calls + " calls");
  }

  @Test
  void boundsReceiveTheOracle() {
    KeepingBound bound = new KeepingBound();
    run(bound);
    assertTrue(bound.receivedViews.stream().allMatch(OracleView.class::isInstance));
    Walk walk = new Walk();
    walk.from(bound.receivedViews.iterator().next());
    assertFalse(walk.found.isEmpty(), "the walk finds an oracle where there is one");
  }

  @Test
  void wrappersReceiveViewOfWrappedPolicy() {
    Keeping wrapper = new Keeping();
    run(OraclePolicy.wrapping(new KeepingBound(), wrapper));
    assertTrue(wrapper.receivedViews.stream().allMatch(OracleView.class::isInstance));
    Keeping deployable = new Keeping();
    run(OraclePolicy.wrapping(new Keeping(), deployable));
    assertTrue(deployable.receivedViews.stream().noneMatch(OracleView.class::isInstance));
  }

  private static void run(ZoomPolicy policy) {
    World world =
        new TestScenario()
            .zooms(2, 5)
            .camera(0, 0)
            .camera(1, 1)
            .target(0, 1)
            .target(3, 0)
            .with(Scenario.CHANNEL, ChannelModel.parse("loss=0.2,delay=1"))
            .world();
    new Simulation(world, Detection.of(new GeometricDetection()), policy, 1, List.of()).run(2);
  }

  private static final class Walk {
    /**
     * The most objects walked per class, because methods that copy return new objects endlessly.
     */
    private static final int INSTANCES = 20;

    final List<String> found = new ArrayList<>();
    int calls;
    private final Map<Class<?>, Integer> walked = new HashMap<>();
    private final Deque<Object> open = new ArrayDeque<>();

    void from(Object start) {
      add(start, "the view");
      while (!open.isEmpty()) {
        Object next = open.remove();
        publicTypes(next.getClass()).forEach(type -> callAll(next, type));
      }
    }

    private void add(Object value, String path) {
      if (value == null || walked.merge(value.getClass(), 1, Integer::sum) > INSTANCES) {
        return;
      }
      ORACLES.stream()
          .filter(oracle -> oracle.isInstance(value))
          .forEach(oracle -> found.add(path + " is a " + oracle.getSimpleName()));
      if (value instanceof Collection<?> items) {
        items.forEach(item -> add(item, path + "[]"));
      } else if (value instanceof Object[] items) {
        Arrays.stream(items).forEach(item -> add(item, path + "[]"));
      } else if (value.getClass().getName().startsWith("org.hificamsim")) {
        open.add(value);
      }
    }

    private void callAll(Object receiver, Class<?> type) {
      for (Method method : type.getMethods()) {
        Class<?> result = method.getReturnType();
        if (ORACLES.stream().anyMatch(oracle -> oracle.isAssignableFrom(result))) {
          found.add(method + " may return an oracle");
        }
        boolean own = method.getDeclaringClass().getName().startsWith("org.hificamsim");
        if (own && !Modifier.isStatic(method.getModifiers())) {
          call(receiver, method);
        }
      }
    }

    private void call(Object receiver, Method method) {
      Object[] arguments =
          Arrays.stream(method.getParameterTypes()).map(Walk::argument).toArray(Object[]::new);
      try {
        add(method.invoke(receiver, arguments), method.getName());
        calls++;
      } catch (IllegalAccessException e) {
        throw new AssertionError(method + " is not public", e);
      } catch (InvocationTargetException e) {
        calls++; // the method rejected the arguments
      }
    }

    private static Object argument(Class<?> type) {
      if (type == SeenPairs.class) {
        return new SeenPairs();
      }
      if (type.isArray()) {
        return Array.newInstance(type.getComponentType(), 100);
      }
      return type.isPrimitive() ? Array.get(Array.newInstance(type, 1), 0) : null;
    }

    private static Set<Class<?>> publicTypes(Class<?> type) {
      Set<Class<?>> types = new LinkedHashSet<>();
      for (Class<?> ancestor = type; ancestor != null; ancestor = ancestor.getSuperclass()) {
        types.add(ancestor);
        Stream.of(ancestor.getInterfaces()).forEach(parent -> types.addAll(publicTypes(parent)));
      }
      types.removeIf(found -> !Modifier.isPublic(found.getModifiers()));
      return types;
    }
  }
}
