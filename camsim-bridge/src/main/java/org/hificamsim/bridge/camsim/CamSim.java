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
 * Calls methods of CamSim's cameras and objects, even if they are not public. Cameras, objects and
 * cores are instances of CamSim's classes, which are known here only as {@link Object}.
 *
 * <p>Exceptions of CamSim are wrapped in an {@link IllegalStateException}.
 */
public final class CamSim {
  /** The argument of {@code change} that leaves a value unchanged. */
  static final double UNCHANGED = -1;

  private final ClassLoader loader;
  private final Map<CamSimMethod, MethodHandle> handles = new EnumMap<>(CamSimMethod.class);

  /**
   * Finds the methods of a CamSim.
   *
   * @param part a core, camera or object of this CamSim
   */
  public CamSim(Object part) {
    loader = part.getClass().getClassLoader();
    for (CamSimMethod method : CamSimMethod.values()) {
      bind(method);
    }
  }

  /** Finds a method, which is missing only if no option needs it. */
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

  /** The cameras of a core, in CamSim's order, including those that are offline. */
  public Collection<?> cameras(Object core) {
    return (Collection<?>) value(CamSimMethod.CAMERAS, core);
  }

  /** The objects in the world, in CamSim's order. */
  public Collection<?> objects(Object core) {
    return (Collection<?>) value(CamSimMethod.OBJECTS, core);
  }

  /** The x coordinate of a camera, in metres. */
  public double cameraX(Object camera) {
    return number(CamSimMethod.CAMERA_X, camera);
  }

  /** The y coordinate of a camera, in metres. */
  public double cameraY(Object camera) {
    return number(CamSimMethod.CAMERA_Y, camera);
  }

  /** The heading, opening angle and range of a camera. */
  public Aim aim(Object camera) {
    return new Aim(
        number(CamSimMethod.HEADING, camera), number(CamSimMethod.ANGLE, camera), range(camera));
  }

  /** The range of a camera, in metres. */
  public double range(Object camera) {
    return number(CamSimMethod.RANGE, camera);
  }

  /** Returns whether a camera has failed. */
  public boolean offline(Object camera) {
    try {
      return (boolean) handles.get(CamSimMethod.OFFLINE).invokeExact(camera);
    } catch (Throwable e) {
      throw failed(e);
    }
  }

  /** The name of a camera; {@code Offline} while it is offline (behaviour 11, Q7). */
  public String cameraName(Object camera) {
    return String.valueOf(value(CamSimMethod.CAMERA_NAME, camera));
  }

  /** The x coordinate of an object, in metres. */
  public double objectX(Object object) {
    return number(CamSimMethod.OBJECT_X, object);
  }

  /** The y coordinate of an object, in metres. */
  public double objectY(Object object) {
    return number(CamSimMethod.OBJECT_Y, object);
  }

  /** The features of an object, joined by semicolons; empty if this CamSim has none. */
  public String features(Object object) {
    if (!handles.containsKey(CamSimMethod.FEATURES)) {
      return "";
    }
    Object value = value(CamSimMethod.FEATURES, object);
    return value instanceof Collection<?> several
        ? several.stream().map(String::valueOf).collect(Collectors.joining(";"))
        : String.valueOf(value);
  }

  /**
   * Sets whether a camera sees an object.
   *
   * @param confidence the confidence that CamSim stores; 0 if the object is not visible
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
    change(camera, UNCHANGED, UNCHANGED, metres);
  }

  /** Sets heading, opening angle and range, with angles in the unit of {@code change}. */
  void change(Object camera, double heading, double angle, double metres) {
    try {
      handles
          .get(CamSimMethod.CHANGE)
          .invokeExact(camera, UNCHANGED, UNCHANGED, heading, angle, metres);
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

  private Object value(CamSimMethod getter, Object owner) {
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
