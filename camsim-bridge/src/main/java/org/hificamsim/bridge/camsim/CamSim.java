package org.hificamsim.bridge.camsim;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;

/**
 * CamSim's cameras and objects: calls of their methods, public or not, by the names of {@link
 * Names}. Cameras, objects and cores are CamSim's own and known here as {@link Object} alone.
 *
 * <p>What CamSim throws comes out as an {@link IllegalStateException}.
 */
public final class CamSim {
  private static final MethodType NUMBER = MethodType.methodType(double.class, Object.class);
  private static final MethodType FLAG = MethodType.methodType(boolean.class, Object.class);
  private static final MethodType ANY = MethodType.methodType(Object.class, Object.class);

  /** What {@code change} takes for a value that is to stay. */
  static final double AS_IT_IS = -1;

  private final ClassLoader loader;
  private final MethodHandle cameras;
  private final MethodHandle objects;
  private final MethodHandle cameraX;
  private final MethodHandle cameraY;
  private final MethodHandle heading;
  private final MethodHandle angle;
  private final MethodHandle range;
  private final MethodHandle offline;
  private final MethodHandle cameraName;
  private final MethodHandle objectX;
  private final MethodHandle objectY;
  private final MethodHandle features;
  private final MethodHandle addVisible;
  private final MethodHandle removeVisible;
  private final MethodHandle change;

  /** The CamSim that {@code part}, a core, camera or object of it, belongs to. */
  public CamSim(Object part) {
    loader = part.getClass().getClassLoader();
    cameras = bind(Names.CAMERAS, ANY);
    objects = bind(Names.OBJECTS, ANY);
    cameraX = bind(Names.CAMERA_X, NUMBER);
    cameraY = bind(Names.CAMERA_Y, NUMBER);
    heading = bind(Names.HEADING, NUMBER);
    angle = bind(Names.ANGLE, NUMBER);
    range = bind(Names.RANGE, NUMBER);
    offline = bind(Names.OFFLINE, FLAG);
    cameraName = bind(Names.CAMERA_NAME, ANY);
    objectX = bind(Names.OBJECT_X, NUMBER);
    objectY = bind(Names.OBJECT_Y, NUMBER);
    features = bind(Names.FEATURES, ANY);
    addVisible =
        bind(
            Names.ADD_VISIBLE,
            MethodType.methodType(void.class, Object.class, Object.class, double.class));
    removeVisible =
        bind(Names.REMOVE_VISIBLE, MethodType.methodType(void.class, Object.class, Object.class));
    change =
        bind(
            Names.CHANGE,
            MethodType.methodType(void.class, Object.class)
                .appendParameterTypes(
                    double.class, double.class, double.class, double.class, double.class));
  }

  /** The cameras of a core, in CamSim's order, those that are offline included. */
  public Collection<?> cameras(Object core) {
    return (Collection<?>) any(cameras, core);
  }

  /** The objects in the world, in CamSim's order. */
  public Collection<?> objects(Object core) {
    return (Collection<?>) any(objects, core);
  }

  /** Metres. */
  public double cameraX(Object camera) {
    return number(cameraX, camera);
  }

  /** Metres. */
  public double cameraY(Object camera) {
    return number(cameraY, camera);
  }

  /** How the camera is aimed. */
  public Aim aim(Object camera) {
    return new Aim(number(heading, camera), number(angle, camera), number(range, camera));
  }

  /** Metres. */
  public double range(Object camera) {
    return number(range, camera);
  }

  /** Whether the camera has failed. */
  public boolean offline(Object camera) {
    try {
      return (boolean) offline.invokeExact(camera);
    } catch (Throwable e) {
      throw failed(e);
    }
  }

  /** The camera's name; {@code Offline} while it is (behaviour 11, Q7). */
  public String cameraName(Object camera) {
    return String.valueOf(any(cameraName, camera));
  }

  /** Metres. */
  public double objectX(Object object) {
    return number(objectX, object);
  }

  /** Metres. */
  public double objectY(Object object) {
    return number(objectY, object);
  }

  /** The object's features, several between semicolons; empty where this CamSim has none. */
  public String features(Object object) {
    if (features == null) {
      return "";
    }
    Object value = any(features, object);
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
        addVisible.invokeExact(camera, object, confidence);
      } else {
        removeVisible.invokeExact(camera, object);
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
  void change(Object camera, double newHeading, double newAngle, double metres) {
    try {
      change.invokeExact(camera, AS_IT_IS, AS_IT_IS, newHeading, newAngle, metres);
    } catch (Throwable e) {
      throw failed(e);
    }
  }

  /** A method as a handle of this type; null where this CamSim has none, and no option needs it. */
  private MethodHandle bind(CamSimMethod method, MethodType type) {
    try {
      for (Class<?> owner = Class.forName(method.type(), false, loader);
          owner != null;
          owner = owner.getSuperclass()) {
        for (java.lang.reflect.Method found : owner.getDeclaredMethods()) {
          if (found.getName().equals(method.name())
              && parameters(found).equals(method.parameters())) {
            return MethodHandles.privateLookupIn(owner, MethodHandles.lookup())
                .unreflect(found)
                .asType(type);
          }
        }
      }
      return null;
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException("method " + method + " cannot be called: " + e, e);
    }
  }

  private static List<String> parameters(java.lang.reflect.Method method) {
    return Arrays.stream(method.getParameterTypes()).map(Class::getName).toList();
  }

  private static double number(MethodHandle getter, Object owner) {
    try {
      return (double) getter.invokeExact(owner);
    } catch (Throwable e) {
      throw failed(e);
    }
  }

  private static Object any(MethodHandle getter, Object owner) {
    try {
      return getter.invokeExact(owner);
    } catch (Throwable e) {
      throw failed(e);
    }
  }

  private static IllegalStateException failed(Throwable cause) {
    return new IllegalStateException("CamSim's own method failed: " + cause, cause);
  }
}
