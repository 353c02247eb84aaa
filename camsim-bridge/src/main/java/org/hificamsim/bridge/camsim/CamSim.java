package org.hificamsim.bridge.camsim;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.Collection;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * CamSim's cameras and objects: calls of their methods, public or not. Cameras, objects and cores
 * are CamSim's own and known here as {@link Object} alone.
 *
 * <p>What CamSim throws comes out as an {@link IllegalStateException}.
 */
public final class CamSim {
  /** What {@code change} takes for a value that is to stay. */
  static final double AS_IT_IS = -1;

  private final ClassLoader loader;
  private final Map<CamSimMethod, MethodHandle> handles = new EnumMap<>(CamSimMethod.class);

  /** The CamSim that {@code part}, a core, camera or object of it, belongs to. */
  public CamSim(Object part) {
    loader = part.getClass().getClassLoader();
    for (CamSimMethod method : CamSimMethod.values()) {
      bind(method);
    }
  }

  /** A method as a handle; none where this CamSim does not have it, and no option needs it. */
  private void bind(CamSimMethod method) {
    try {
      for (Class<?> owner = Class.forName(method.type.name, false, loader);
          owner != null && !handles.containsKey(method);
          owner = owner.getSuperclass()) {
        for (Method found : owner.getDeclaredMethods()) {
          List<String> parameters =
              Arrays.stream(found.getParameterTypes()).map(Class::getName).toList();
          if (method.is(found.getName(), parameters)) {
            MethodHandle handle =
                MethodHandles.privateLookupIn(owner, MethodHandles.lookup()).unreflect(found);
            handles.put(method, handle.asType(method.handleType()));
          }
        }
      }
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(
          "method " + method.signature() + " cannot be called: " + e, e);
    }
  }

  /** The cameras of a core, in CamSim's order, those that are offline included. */
  public Collection<?> cameras(Object core) {
    return (Collection<?>) any(CamSimMethod.CAMERAS, core);
  }

  /** The objects in the world, in CamSim's order. */
  public Collection<?> objects(Object core) {
    return (Collection<?>) any(CamSimMethod.OBJECTS, core);
  }

  /** Metres. */
  public double cameraX(Object camera) {
    return number(CamSimMethod.CAMERA_X, camera);
  }

  /** Metres. */
  public double cameraY(Object camera) {
    return number(CamSimMethod.CAMERA_Y, camera);
  }

  /** How the camera is aimed. */
  public Aim aim(Object camera) {
    return new Aim(
        number(CamSimMethod.HEADING, camera), number(CamSimMethod.ANGLE, camera), range(camera));
  }

  /** Metres. */
  public double range(Object camera) {
    return number(CamSimMethod.RANGE, camera);
  }

  /** Whether the camera has failed. */
  public boolean offline(Object camera) {
    try {
      return (boolean) handles.get(CamSimMethod.OFFLINE).invokeExact(camera);
    } catch (Throwable e) {
      throw failed(e);
    }
  }

  /** The camera's name; {@code Offline} while it is (behaviour 11, Q7). */
  public String cameraName(Object camera) {
    return String.valueOf(any(CamSimMethod.CAMERA_NAME, camera));
  }

  /** Metres. */
  public double objectX(Object object) {
    return number(CamSimMethod.OBJECT_X, object);
  }

  /** Metres. */
  public double objectY(Object object) {
    return number(CamSimMethod.OBJECT_Y, object);
  }

  /** The object's features, several between semicolons; empty where this CamSim has none. */
  public String features(Object object) {
    if (!handles.containsKey(CamSimMethod.FEATURES)) {
      return "";
    }
    Object value = any(CamSimMethod.FEATURES, object);
    return value instanceof Collection<?> several
        ? several.stream().map(String::valueOf).collect(Collectors.joining(";"))
        : String.valueOf(value);
  }

  /**
   * Sets whether a camera sees an object from now on, whether or not it did.
   *
   * @param confidence what CamSim keeps for it; 0 where it is not visible
   */
  public void setVisible(Object camera, Object object, double confidence) {
    try {
      if (confidence > 0) {
        handles.get(CamSimMethod.ADD_VISIBLE).invokeExact(camera, object, confidence);
      } else {
        handles.get(CamSimMethod.REMOVE_VISIBLE).invokeExact(camera, object);
      }
    } catch (Throwable e) {
      throw failed(e);
    }
  }

  /**
   * Sets a camera's range as a {@code change} event does, without the clamp of CamSim's own zoom.
   *
   * @param metres 0 or more
   */
  public void changeRange(Object camera, double metres) {
    change(camera, AS_IT_IS, AS_IT_IS, metres);
  }

  /** The same of heading and opening angle, in the unit that {@code change} takes. */
  void change(Object camera, double heading, double angle, double metres) {
    try {
      handles
          .get(CamSimMethod.CHANGE)
          .invokeExact(camera, AS_IT_IS, AS_IT_IS, heading, angle, metres);
    } catch (Throwable e) {
      throw failed(e);
    }
  }

  private double number(CamSimMethod getter, Object owner) {
    try {
      return (double) handles.get(getter).invokeExact(owner);
    } catch (Throwable e) {
      throw failed(e);
    }
  }

  private Object any(CamSimMethod getter, Object owner) {
    try {
      return handles.get(getter).invokeExact(owner);
    } catch (Throwable e) {
      throw failed(e);
    }
  }

  private static IllegalStateException failed(Throwable cause) {
    return new IllegalStateException("CamSim's own method failed: " + cause, cause);
  }
}
