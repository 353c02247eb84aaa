package org.hificamsim.bridge.camsim;

import java.util.ArrayList;
import java.util.List;
import net.bytebuddy.description.method.MethodDescription;
import net.bytebuddy.description.type.TypeDefinition;
import net.bytebuddy.description.type.TypeDescription;
import net.bytebuddy.dynamic.ClassFileLocator;
import net.bytebuddy.pool.TypePool;

/**
 * What CamSim has to look like: the classes and methods that a setup needs, looked up in the class
 * files without loading them.
 *
 * @param detects whether the bridge decides what cameras see
 * @param steers whether the bridge sets ranges
 * @param records whether the bridge writes files
 * @param tracks whether objects follow tracks
 */
public record Requirements(boolean detects, boolean steers, boolean records, boolean tracks) {
  /** Those names that a class path lacks, or has in another form; empty when all is there. */
  public List<String> missing(ClassLoader loader) {
    TypePool pool = TypePool.Default.of(ClassFileLocator.ForClassLoader.of(loader));
    List<String> missing = new ArrayList<>();
    for (String type : List.of(Names.CORE, Names.CAMERA, Names.OBJECT)) {
      TypePool.Resolution found = pool.describe(type);
      if (found.isResolved()) {
        needed().stream()
            .filter(method -> method.type().equals(type))
            .filter(method -> !isThere(method, found.resolve()))
            .map(method -> "method " + method)
            .distinct()
            .forEach(missing::add);
      } else {
        missing.add("class " + type);
      }
    }
    return missing;
  }

  private List<CamSimMethod> needed() {
    List<CamSimMethod> needed = new ArrayList<>(Names.ALWAYS);
    if (detects) {
      needed.addAll(Names.TO_DETECT);
    }
    if (steers) {
      needed.add(Names.CHANGE);
    }
    if (records) {
      needed.addAll(Names.TO_RECORD);
    }
    if (tracks) {
      needed.addAll(Names.TO_TRACK);
    }
    return needed;
  }

  private static boolean isThere(CamSimMethod method, TypeDescription type) {
    for (TypeDefinition owner = type; owner != null; owner = owner.getSuperClass()) {
      for (MethodDescription found : owner.getDeclaredMethods()) {
        if (matches(method, found)) {
          return true;
        }
      }
      if (method.woven()) {
        return false;
      }
    }
    return false;
  }

  private static boolean matches(CamSimMethod method, MethodDescription found) {
    List<String> parameters =
        found.getParameters().asTypeList().asErasures().stream()
            .map(TypeDescription::getName)
            .toList();
    return found.getName().equals(method.name())
        && !found.isStatic()
        && parameters.equals(method.parameters())
        && method.returned().test(found.getReturnType().asErasure().getName());
  }
}
