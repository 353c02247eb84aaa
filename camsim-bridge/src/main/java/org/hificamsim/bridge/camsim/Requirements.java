package org.hificamsim.bridge.camsim;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import net.bytebuddy.description.method.MethodDescription;
import net.bytebuddy.description.type.TypeDefinition;
import net.bytebuddy.description.type.TypeDescription;
import net.bytebuddy.dynamic.ClassFileLocator;
import net.bytebuddy.pool.TypePool;

/** Checks that CamSim has the required classes and methods, without loading its classes. */
public final class Requirements {
  private Requirements() {}

  /**
   * Returns the classes and methods that are missing from a class path, or have other signatures.
   *
   * @return empty if nothing is missing
   */
  public static List<String> missing(Set<Use> uses, ClassLoader loader) {
    TypePool pool = TypePool.Default.of(ClassFileLocator.ForClassLoader.of(loader));
    List<String> missing = new ArrayList<>();
    for (CamSimMethod.Type type : CamSimMethod.Type.values()) {
      TypePool.Resolution found = pool.describe(type.name);
      if (found.isResolved()) {
        Arrays.stream(CamSimMethod.values())
            .filter(method -> method.type == type && uses.contains(method.use))
            .filter(method -> !hasMethod(method, found.resolve()))
            .map(method -> "method " + method.signature())
            .distinct()
            .forEach(missing::add);
      } else {
        missing.add("class " + type.name);
      }
    }
    return missing;
  }

  private static boolean hasMethod(CamSimMethod method, TypeDescription type) {
    for (TypeDefinition owner = type; owner != null; owner = owner.getSuperClass()) {
      if (owner.getDeclaredMethods().stream().anyMatch(found -> matches(method, found))) {
        return true;
      }
      if (method.advice != null) {
        return false;
      }
    }
    return false;
  }

  static boolean matches(CamSimMethod method, MethodDescription found) {
    List<String> parameters =
        found.getParameters().asTypeList().asErasures().stream()
            .map(TypeDescription::getName)
            .toList();
    return !found.isStatic()
        && method.is(found.getName(), parameters)
        && method.returns(found.getReturnType().asErasure().getName());
  }
}
